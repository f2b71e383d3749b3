#include "fuzz_row.h"
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "cell.h"
#include "chosen.h"

void aob_fuzz_row_finish(struct aob_fuzz_row *row)
{
    for (size_t i = 0; i < row->finding_count; i++) {
        free(row->findings[i].sentence);
        json_decref(row->findings[i].smallest);
    }
    free(row->findings);
    free(row->device);
    free(row->driver);
    free(row->missing);
    *row = (struct aob_fuzz_row){0};
}

static struct aob_fuzz_finding *finding_of(struct aob_fuzz_row *row, const struct aob_fuzz_answer *answer)
{
    enum aob_fuzz_fault fault = aob_fuzz_fault_find(answer->fault);
    for (size_t i = 0; i < row->finding_count; i++)
        if (row->findings[i].fault == fault && row->findings[i].hostile == answer->hostile)
            return &row->findings[i];
    struct aob_fuzz_finding *finding = AOB_PUSH(row->findings, row->finding_count, row->finding_capacity);
    *finding = (struct aob_fuzz_finding){.fault = fault,
                                         .hostile = answer->hostile,
                                         .index = answer->index,
                                         .sentence = aob_strdup(answer->sentence)};
    return finding;
}

/* Two workers may each have made one smaller; the first frame of the two stays. */
static void take_found(struct aob_fuzz_row *row, const struct aob_fuzz_answer *answer)
{
    struct aob_fuzz_finding *finding = finding_of(row, answer);
    finding->count++;
    if (!answer->smallest || (finding->smallest && finding->index < answer->index))
        return;
    json_decref(finding->smallest);
    free(finding->sentence);
    finding->smallest = json_incref(answer->smallest);
    finding->sentence = aob_strdup(answer->sentence);
    finding->index = answer->index;
}

void aob_fuzz_row_take(struct aob_fuzz_row *row, const struct aob_fuzz_answer *answer)
{
    if (answer->message == AOB_FUZZ_OPENED && !row->device) {
        row->device = aob_strdup(answer->device);
        row->driver = aob_strdup(answer->driver);
    }
    row->begun += answer->message == AOB_FUZZ_BEGUN;
    row->refused += answer->message == AOB_FUZZ_REFUSES;
    if (answer->message == AOB_FUZZ_FOUND)
        take_found(row, answer);
}

uint32_t aob_fuzz_row_known(const struct aob_fuzz_row *row)
{
    uint32_t known = 0;
    for (size_t i = 0; i < row->finding_count; i++)
        known |= 1u << (2 * (int)row->findings[i].fault + row->findings[i].hostile);
    return known;
}

static void add_command(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *row,
                        const struct aob_fuzz_finding *finding, struct aob_text *text)
{
    aob_chosen_command(row->technique, row->backend, desc->dispatch.device, text);
    aob_text_add(text, " --seed %llu --fuzz 1 --from %llu", (unsigned long long)desc->seed,
                 (unsigned long long)finding->index);
}

static json_t *finding_to_json(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *row,
                               const struct aob_fuzz_finding *finding)
{
    struct aob_text command = {0};
    add_command(desc, row, finding, &command);
    json_t *object =
        json_pack("{s:s, s:b, s:I, s:I, s:o, s:O?, s:o}", "fault", aob_fuzz_fault_word(finding->fault),
                  "hostile", finding->hostile, "frames", (json_int_t)finding->count, "index",
                  (json_int_t)finding->index, "sentence", aob_json_text(finding->sentence), "smallest",
                  finding->smallest, "command", aob_json_text(command.data));
    aob_text_finish(&command);
    return object;
}

static json_t *row_to_json(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *row)
{
    json_t *findings = json_array();
    for (size_t i = 0; i < row->finding_count; i++)
        json_array_append_new(findings, finding_to_json(desc, row, &row->findings[i]));
    const struct aob_technique_info *t = row->technique;
    return json_pack("{s:s, s:s?, s:s, s:s, s:s?, s:s?, s:s?, s:I, s:I, s:o}", "technique", t->name, "module",
                     t->module, "digest", t->digest, "backend", row->backend, "device", row->device, "driver",
                     row->driver, "missing", row->missing, "frames", (json_int_t)row->begun, "refused",
                     (json_int_t)row->refused, "findings", findings);
}

json_t *aob_fuzz_to_json(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *rows, size_t count,
                         const struct aob_fuzz_sums *sums)
{
    json_t *list = json_array();
    for (size_t r = 0; r < count; r++)
        json_array_append_new(list, row_to_json(desc, &rows[r]));
    return json_pack("{s:I, s:I, s:I, s:I, s:I, s:f, s:o}", "seed", (json_int_t)desc->seed, "from",
                     (json_int_t)desc->from, "frames", (json_int_t)sums->begun, "refused",
                     (json_int_t)sums->refused, "failed", (json_int_t)sums->failed, "seconds", sums->seconds,
                     "rows", list);
}

/* What of the smallest frame is no default is in its file; here is what a reader wants first. */
static void print_finding(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *row,
                          const struct aob_fuzz_finding *finding, struct aob_text *out)
{
    struct aob_text command = {0};
    const char *small = json_string_value(json_object_get(finding->smallest, "sentence"));
    add_command(desc, row, finding, &command);
    aob_text_add_line(out, "FAIL %s on %s: %s in %llu frames%s: frame %llu: %s%s%s", row->technique->name,
                      row->backend, aob_fuzz_fault_word(finding->fault), (unsigned long long)finding->count,
                      finding->hostile ? " with hostile pixels" : "", (unsigned long long)finding->index,
                      finding->sentence, small ? "; made smaller: " : "", small ? small : "");
    aob_text_add_line(out, "     shown again by: %s --out DIR", command.data);
    aob_text_finish(&command);
}

void aob_fuzz_print(const struct aob_fuzz_desc *desc, const struct aob_fuzz_row *rows, size_t count,
                    const struct aob_fuzz_sums *sums, struct aob_text *out)
{
    for (size_t r = 0; r < count; r++) {
        if (rows[r].missing)
            aob_text_add_line(out, "MISSING %s", rows[r].missing);
        for (size_t i = 0; i < rows[r].finding_count; i++)
            print_finding(desc, &rows[r], &rows[r].findings[i], out);
    }
    aob_text_add_line(out, "seed %llu: %llu frames, %llu refused, %llu fail; %.0f a second",
                      (unsigned long long)desc->seed, (unsigned long long)sums->begun,
                      (unsigned long long)sums->refused, (unsigned long long)sums->failed,
                      (double)sums->begun / sums->seconds);
}
