/* For papers_rows.c: how each row is measured. False after one line if a case is missing or not ok. */
#ifndef AOB_PAPERS_MEASURE_H
#define AOB_PAPERS_MEASURE_H
#include "row.h"

typedef bool aob_paper_measure(const struct aob_paper_run *run, struct aob_paper_result *result,
                               struct aob_error *error);
aob_paper_measure aob_paper_alchemy_samples, aob_paper_alchemy_filter, aob_paper_alchemy_radius,
    aob_paper_alchemy_distance, aob_paper_alchemy_lod, aob_paper_alchemy_field, aob_paper_alchemy_guard,
    aob_paper_alchemy_volumetric, aob_paper_alchemy_floating, aob_paper_alchemy_dragon,
    aob_paper_alchemy_epsilon, aob_paper_alchemy_beta, aob_paper_hbao_samples, aob_paper_hbao_blur,
    aob_paper_hbao_half, aob_paper_hbao_half_ao, aob_paper_crytek_half, aob_paper_starcraft2_blur,
    aob_paper_gtao_error, aob_paper_gtao_half, aob_paper_aov_solid, aob_paper_aov_thin;
#endif
