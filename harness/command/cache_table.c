#include "cache_table.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/json.h"

enum { BAND = 64 };

static double number(const json_t *object, const char *name)
{
    return aob_json_to_number(json_object_get(object, name));
}

static void show(char text[24], double value)
{
    double size = fabs(value);
    snprintf(text, 24, size >= 99.95 ? "%.0f" : size >= 9.995 ? "%.1f" : "%.2f", value);
}

/* "1.23 .. 45.6", or one number where both look alike. */
static void band(char text[BAND], double one, double most)
{
    char a[24], b[24];
    show(a, one);
    show(b, most);
    if (strcmp(a, b) == 0)
        snprintf(text, BAND, "%s", a);
    else
        snprintf(text, BAND, "%s .. %s", a, b);
}

static void member_band(char text[BAND], const json_t *level, const char *name, double scale)
{
    band(text, scale * number(json_object_get(level, "one"), name),
         scale * number(json_object_get(level, "most"), name));
}

/* A share of the level's accesses, in percent. */
static void share_band(char text[BAND], const json_t *level, const char *name)
{
    const json_t *one = json_object_get(level, "one"), *most = json_object_get(level, "most");
    band(text, 100 * number(one, name) / number(one, "accesses"),
         100 * number(most, name) / number(most, "accesses"));
}

static void print_level(const json_t *level, struct aob_text *out)
{
    static const char *const causes[] = {"compulsory", "capacity", "conflict"};
    char misses[BAND], fills[BAND], bytes[BAND], cause[3][BAND];
    member_band(misses, level, "miss_ratio", 100);
    member_band(fills, level, "fills_per_pixel", 1);
    member_band(bytes, level, "bytes_per_pixel", 1);
    for (int i = 0; i < 3; i++)
        share_band(cause[i], level, causes[i]);
    bool split = json_is_integer(json_object_get(json_object_get(level, "one"), "capacity"));
    aob_text_add_line(out, "  %-6s %-16s %-16s %-16s %-14s %-16s %s",
                      json_string_value(json_object_get(level, "name")), misses, fills, bytes, cause[0],
                      split ? cause[1] : "-", split ? cause[2] : "-");
}

static void add_bytes(double bytes, char text[24])
{
    static const char *const units[] = {"B", "KiB", "MiB", "GiB"};
    size_t u = 0;
    for (; bytes >= 1024 && u < 3; u++)
        bytes /= 1024;
    snprintf(text, 24, "%.4g %s", bytes, units[u]);
}

/* Sizes of a fully associative first level, from the last that misses as much as one line does to the first that misses as
 * little as any. */
static void print_curve(const json_t *figures, struct aob_text *out)
{
    const json_t *frame = json_object_get(figures, "frame"), *curve = json_object_get(frame, "curve");
    const json_t *one = json_object_get(curve, "one"), *most = json_object_get(curve, "most");
    const json_t *lines = json_object_get(one, "lines");
    double texels = number(frame, "texels"), line = number(figures, "line_bytes");
    size_t count = json_array_size(lines);
    for (size_t i = 0; i < count; i++) {
        double m = aob_json_to_number(json_array_get(json_object_get(one, "misses"), i)),
               k = aob_json_to_number(json_array_get(json_object_get(most, "misses"), i));
        char size[24], text[BAND];
        add_bytes(line * aob_json_to_number(json_array_get(lines, i)), size);
        band(text, 100 * m / texels, 100 * k / texels);
        aob_text_add_line(out, "  %-9s %s", size, text);
    }
}

/* "1.9 ms (1.4 .. 3), limited by texture": the point and its band. */
static void print_time(const char *what, const char *name, const json_t *times, struct aob_text *out)
{
    aob_text_add_line(out, "  %s %s: %.3g ms (%.3g .. %.3g), limited by %s", what, name, number(times, "ms"),
                      number(times, "low_ms"), number(times, "high_ms"),
                      json_string_value(json_object_get(times, "limit")));
}

/* Of the frame, and of each pass where there are several. */
static void print_modelled(const char *profile, const json_t *modelled, struct aob_text *out)
{
    const json_t *passes = json_object_get(modelled, "passes"), *pass;
    size_t i, count = json_array_size(passes);
    print_time("modelled on", profile, json_object_get(modelled, "frame"), out);
    json_array_foreach(passes, i, pass) if (count > 1)
        print_time("  pass", json_string_value(json_object_get(pass, "name")), pass, out);
}

void aob_cache_table_print(const char *profile, const json_t *figures, struct aob_text *out)
{
    const json_t *frame = json_object_get(figures, "frame"), *level;
    double pixels = number(frame, "width") * number(frame, "height");
    size_t i;
    aob_text_add_line(out, "%s: %.0f %s, 1 .. %.0f warps in flight", profile, number(figures, "units"),
                      number(figures, "units") == 1 ? "unit" : "units", number(figures, "in_flight"));
    aob_text_add_line(out,
                      "  fetched %.0f times, %.4g a pixel; distinct within an invocation %.0f, %.4g a pixel; "
                      "lanes busy %.1f %%",
                      number(frame, "fetches"), number(frame, "fetches") / pixels, number(frame, "distinct"),
                      number(frame, "distinct") / pixels, 100 * number(frame, "lanes_busy"));
    aob_text_add_line(out, "  %-6s %-16s %-16s %-16s %-14s %-16s %s", "level", "misses, %", "fills a pixel",
                      "bytes a pixel", "compulsory, %", "capacity, %", "conflict, %");
    json_array_foreach(json_object_get(frame, "levels"), i, level) print_level(level, out);
    if (json_is_object(json_object_get(figures, "modelled")))
        print_modelled(profile, json_object_get(figures, "modelled"), out);
    if (json_object_get(figures, "not_modelled"))
        aob_text_add_line(out, "  not modelled: %s",
                          json_string_value(json_object_get(figures, "not_modelled")));
    if (json_object_get(frame, "curve")) {
        aob_text_add_line(out, "  fully associative first level of each size: misses, %%");
        print_curve(figures, out);
    }
}
