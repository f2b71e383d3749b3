/* The tables of a history. Const data; docs/design.md, "History", has them for people who ask with SQL. */
#ifndef AOB_HISTORY_SCHEMA_H
#define AOB_HISTORY_SCHEMA_H

enum {
    AOB_HISTORY_APPLICATION = 0x616f6268, /* "aobh": the header's application_id */
    AOB_HISTORY_VERSION = 1,              /* the header's user_version: of the tables below */
};

/* Makes the tables of an empty database, and names it a history. */
extern const char aob_history_schema[];
#endif
