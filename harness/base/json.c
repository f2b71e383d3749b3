#include "json.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "file.h"
#include "memory.h"
#include "output.h"
#include "text.h"

json_t *aob_json_number(double value)
{
    if (isnan(value))
        return json_null();
    return isinf(value) ? json_string(value > 0 ? "inf" : "-inf") : json_real(value);
}

double aob_json_to_number(const json_t *value)
{
    if (json_is_number(value))
        return json_number_value(value);
    const char *text = json_string_value(value);
    return text && strcmp(text, "inf") == 0 ? INFINITY : NAN;
}

json_t *aob_json_vector(const double *values, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_json_number(values[i]));
    return array;
}

bool aob_json_to_vector(const json_t *array, double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        values[i] = aob_json_to_number(json_array_get(array, i));
        if (!isfinite(values[i]))
            return false;
    }
    return json_array_size(array) == count;
}

json_t *aob_json_text(const char *text)
{
    struct aob_text shown = {0};
    aob_text_add_shown(&shown, text, strlen(text), false);
    json_t *value = json_stringn(shown.data ? shown.data : "", shown.size);
    aob_text_finish(&shown);
    return value;
}

json_t *aob_json_path(const char *path)
{
    char *absolute = path ? aob_path_absolute(path) : NULL;
    json_t *value = absolute ? json_string(absolute) : json_null();
    free(absolute);
    return value ? value : json_string(path);
}

char *aob_json_line(const json_t *value, int digits)
{
    return json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION((size_t)digits) | JSON_ENCODE_ANY);
}

bool aob_json_send(int file, const json_t *value)
{
    char *line = aob_json_line(value, 17);
    size_t size = strlen(line);
    line[size++] = '\n'; /* in place of the end of the text */
    bool ok = aob_file_send(file, line, size);
    free(line);
    return ok;
}

bool aob_json_write(const json_t *document, const char *path, struct aob_error *error)
{
    char *text = json_dumps(document, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
    size_t size = strlen(text);
    text = aob_realloc(text, size + 2, 1);
    memcpy(text + size, "\n", 2);
    bool ok = strcmp(path, "-") == 0 ? aob_output_write(text, size + 1, error)
                                     : aob_file_write(path, text, size + 1, error);
    free(text);
    return ok;
}

bool aob_json_check(const char *path, struct aob_error *error)
{
    return !path || strcmp(path, "-") == 0 || aob_file_check(path, error);
}
