/* A growing string, and numbers read strictly. */
#ifndef AOB_BASE_TEXT_H
#define AOB_BASE_TEXT_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

struct aob_text {
    char *data;        /* NUL-ended once anything was added; NULL before */
    size_t size, room; /* room: bytes allocated */
};

void aob_text_add(struct aob_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
void aob_text_add_bytes(struct aob_text *text, const char *bytes, size_t size);
void aob_text_finish(struct aob_text *text); /* frees; the struct is empty again */

/* Adds what may be shown of a text whose parts came from outside: on a terminal a control character is a command. It
 * becomes an escape (\u001b), also one that turns the direction of the text (\u202e), as does a byte that is no UTF-8
 * (\xff). Line breaks stay if `lines`; otherwise they and tabs become spaces. JSON stays JSON, and means the same. */
void aob_text_add_shown(struct aob_text *text, const char *bytes, size_t size, bool lines);
/* Adds one line for people by the rule above, with a line break at its end. */
void aob_text_add_line(struct aob_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Writes a line for people into an array of `size` bytes, shown as above, so it is UTF-8 and can go into JSON. If it
 * does not fit, paths are cut in their middle ("/home/a...b/box.obj: cause"), so that what stands behind them stays. If
 * that is not enough, it is cut at a character's border and ends in "...". So never write with it what a program reads,
 * such as a path. */
void aob_line_print(char *line, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void aob_line_print_list(char *line, size_t size, const char *format, va_list args);

/* Reads a number, which must be the whole of `text`: trailing junk, NaN, overflow and an empty string are refused,
 * and `inf` is accepted. Returns false and leaves *value alone otherwise. */
bool aob_parse_double(const char *text, double *value);

/* Reads "3%" or "0.5%" as a share, .03 or .005. The sign must be there, since 3 alone could be 300 %. */
bool aob_parse_percent(const char *text, double *share);

/* Reads "WxH"; both are in 1..16384. */
bool aob_parse_size(const char *text, int *width, int *height);

/* Each reads finite numbers: "x,y,z" or "x,y". */
bool aob_parse_vec3(const char *text, double value[3]);
bool aob_parse_vec2(const char *text, double value[2]);
#endif
