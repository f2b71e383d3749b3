#include "error.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "text.h"

bool aob_fail(struct aob_error *error, const char *format, ...)
{
    if (!error)
        return false;
    va_list args;
    va_start(args, format);
    aob_line_print_list(error->text, sizeof error->text, format, args);
    va_end(args);
    return false;
}

bool aob_fail_in(struct aob_error *error, const char *format, ...)
{
    if (!error)
        return false;
    char cause[sizeof error->text];
    memcpy(cause, error->text, sizeof cause);
    /* A long prefix, such as a path, leaves two thirds of the line to the cause if that needs them. */
    size_t least = sizeof cause / 3, rest = sizeof cause - strlen(cause);
    va_list args;
    va_start(args, format);
    aob_line_print_list(error->text, rest > least + 2 ? rest - 2 : least, format, args);
    va_end(args);
    size_t used = strlen(error->text);
    aob_line_print(error->text + used, sizeof error->text - used, ": %s", cause);
    return false;
}

static void print_line(const char *kind, const char *text)
{
    struct aob_text line = {0};
    aob_text_add_line(&line, "aobudget: %s%s", kind, text);
    fputs(line.data, stderr);
    aob_text_finish(&line);
}

void aob_error_print(const struct aob_error *error)
{
    print_line("error: ", error->text);
}

static void print_formatted(const char *kind, const char *format, va_list args)
{
    char text[1600];
    aob_line_print_list(text, sizeof text, format, args);
    print_line(kind, text);
}

void aob_warn(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print_formatted("warning: ", format, args);
    va_end(args);
}

void aob_note(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    print_formatted("", format, args);
    va_end(args);
}
