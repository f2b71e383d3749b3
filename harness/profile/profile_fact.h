/* For profile_read.c: numbers with their sources, from a table of fields. Each is written
 * {value: 16 KiB, confirmed: where} or {value: 4, unverified: why}. */
#ifndef AOB_PROFILE_PROFILE_FACT_H
#define AOB_PROFILE_PROFILE_FACT_H
#include "config/yaml.h"
#include "profile.h"

enum aob_field_kind {
    AOB_FIELD_WHOLE,  /* uint32_t, or an int that is not negative */
    AOB_FIELD_CORES,  /* int; "machine": the first caches of this one's processors */
    AOB_FIELD_UNITS,  /* int; "all": 0 */
    AOB_FIELD_BYTES,  /* uint64_t; with KiB, MiB ... behind it or without */
    AOB_FIELD_SIZE2,  /* struct aob_size2, both powers of two */
    AOB_FIELD_LAYOUT, /* enum aob_layout */
    AOB_FIELD_INDEX,  /* enum aob_index */
    AOB_FIELD_COLD,   /* bool; "pass" or "frame" */
    AOB_FIELD_REAL,   /* double */
    AOB_FIELD_BOOL,   /* bool; true or false */
};
struct aob_field {
    const char *key;
    enum aob_field_kind kind;
    double low, high; /* of the number */
    size_t offset;    /* in the target */
    bool needed;
};
enum { AOB_FIELD_MAX = 16 };
struct aob_field_reader {           /* of one mapping */
    struct aob_profile *profile;    /* that gets the facts */
    const char *prefix;             /* of their keys: "" or "levels.L1." */
    const struct aob_field *fields; /* ended by a NULL key */
    void *target;
    const yaml_node_t *nodes[AOB_FIELD_MAX]; /* the value of each field; NULL: it is not in the file */
};

/* Reads an entry whose key is one of the fields: an aob_yaml_entry, whose user is the reader. */
bool aob_field_read(struct aob_yaml *yaml, const char *key, yaml_node_t *value, void *user);

/* False with a line if a field that is needed was not in the mapping. */
bool aob_field_need(struct aob_yaml *yaml, const yaml_node_t *node, const struct aob_field_reader *reader);

/* Notes what stands in place of a field that was not in the mapping, as unverified; `field` is its place in the table. Does
 * nothing where the field was there. */
void aob_field_default(const struct aob_field_reader *reader, size_t field, const char *value,
                       const char *source);
#endif
