#include "past.h"
#include <stdint.h>
#include <stdlib.h>
#include "base/memory.h"

void aob_past_take(const struct aob_frame *frame, struct aob_past *past)
{
    *past = (struct aob_past){.number = frame->number};
    for (int i = 0; i < frame->graph.texture_count; i++)
        if (frame->graph.textures[i].kept)
            past->left[i] = (struct aob_gpu_texture *)(uintptr_t)aob_frame_texture(frame, i);
}

static bool keeps_history(const struct aob_frame_desc *desc, bool *keeps, struct aob_error *error)
{
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    bool ok = aob_graph_build(graph, desc->technique, desc->values, desc->wanted, error);
    *keeps = ok && aob_graph_keeps_history(graph);
    free(graph);
    return ok;
}

bool aob_first_init(struct aob_first *first, struct aob_screen *screen, const struct aob_frame_desc *desc,
                    struct aob_error *error)
{
    const struct aob_frame_desc plain = {
        .technique = desc->technique, .values = desc->values, .fetch = desc->fetch, .wanted = desc->wanted};
    bool keeps;
    *first = (struct aob_first){.unfit = false};
    if (!keeps_history(desc, &keeps, error))
        return false;
    if (!keeps)
        return true;
    bool ok = aob_frame_init_desc(&first->frame, screen, &plain, error);
    first->unfit = first->frame.unfit;
    if (!ok)
        return false;
    if (!aob_frame_run(&first->frame, 1, NULL, error)) {
        aob_first_finish(first);
        return false;
    }
    aob_past_take(&first->frame, &first->past);
    return true;
}

void aob_first_finish(struct aob_first *first)
{
    aob_frame_finish(&first->frame);
}

const struct aob_past *aob_first_past(const struct aob_first *first)
{
    return first->frame.screen ? &first->past : NULL;
}
