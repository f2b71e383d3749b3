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

/* A line for people into an array of `size` bytes. What does not fit is cut, and the line then ends in "...". Nothing that
 * a program reads, such as a path, is written with it. */
void aob_line_print(char *line, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));
void aob_line_print_list(char *line, size_t size, const char *format, va_list args);

/* The whole of `text` must be one number: no trailing junk, no NaN, no overflow, no empty string.
 * `inf` is accepted by aob_parse_double only. Returns false and leaves *value alone otherwise. */
bool aob_parse_double(const char *text, double *value);

/* "WxH", both 1..16384. */
bool aob_parse_size(const char *text, int *width, int *height);

/* "x,y,z" and "x,y": finite numbers. */
bool aob_parse_vec3(const char *text, double value[3]);
bool aob_parse_vec2(const char *text, double value[2]);
#endif
