#include "cell.h"

void aob_paper_cell(struct aob_text *table, const char *text)
{
    aob_text_add(table, " ");
    for (; *text; text++)
        aob_text_add(table, *text == '|' ? "\\|" : "%c", *text == '\n' ? ' ' : *text);
    aob_text_add(table, " |");
}
