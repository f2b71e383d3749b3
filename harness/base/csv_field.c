#include "csv_field.h"
#include <math.h>
#include <string.h>

void aob_csv_add_text(struct aob_text *csv, const char *text)
{
    if (!text[strcspn(text, ",\"\r\n")]) {
        aob_text_add(csv, "%s", text);
        return;
    }
    aob_text_add(csv, "\"");
    for (; *text; text++)
        aob_text_add(csv, *text == '"' ? "\"\"" : "%c", *text);
    aob_text_add(csv, "\"");
}

void aob_csv_add_number(struct aob_text *csv, double value)
{
    if (!isnan(value))
        aob_text_add(csv, fabs(value) < 1e15 && value == floor(value) ? "%.0f" : "%.9g", value);
}
