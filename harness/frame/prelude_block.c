#include <string.h>
#include "prelude.h"

size_t aob_prelude_uniforms(const struct aob_prelude_desc *desc, const struct aob_projection *projection,
                            int frame, unsigned char block[AOB_UNIFORM_MAX])
{
    const struct aob_technique *technique = desc->graph->technique;
    double g = aob_graph_depth_divisor(desc->graph, desc->pass);
    float lens[4] = {(float)(projection->sx * g), (float)(projection->sy * g),
                     (float)((projection->cx - 0.5) / g + 0.5), (float)((projection->cy - 0.5) / g + 0.5)};
    int32_t sizes[4] = {projection->width, projection->height}, misc[4] = {frame};
    float range[4] = {desc->encoding->near, desc->encoding->far};
    aob_graph_divided(projection->width, projection->height,
                      aob_graph_target_divisor(desc->graph, desc->pass), &sizes[2], &sizes[3]);
    memset(block, 0, AOB_UNIFORM_MAX);
    memcpy(block, lens, sizeof lens);
    memcpy(block + 16, sizes, sizeof sizes);
    memcpy(block + 32, misc, sizeof misc);
    memcpy(block + 48, range, sizeof range);
    size_t used = AOB_UNIFORM_HEAD;
    for (int i = 0; desc->pass->reads & AOB_LIGHT && i < 9; i++, used += 16)
        for (int c = 0; c < 3; c++) {
            float number = (float)desc->light->sh[i][c];
            memcpy(block + used + 4 * c, &number, sizeof number);
        }
    for (int i = 0; desc->pass->reads & AOB_VELOCITY && i < 3; i++, used += 16)
        for (int c = 0; c < 4; c++) {
            float number = (float)desc->then->m[i][c];
            memcpy(block + used + 4 * c, &number, sizeof number);
        }
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (technique->params[i].stage == AOB_UNIFORM) {
            memcpy(block + used, (const char *)desc->values + technique->params[i].offset, 4);
            used += 4;
        }
    return (used + 15) / 16 * 16;
}
