/* For rows.c: how each row is measured, and what may be said of one that is not reproduced (row.h). */
#ifndef AOB_PAPERS_MEASURE_H
#define AOB_PAPERS_MEASURE_H
#include "row.h"

#define MEASURE(name)                                                                                        \
    bool name(const struct aob_paper_run *run, struct aob_paper_result *result, struct aob_error *error)
#define WHY(name) void name(const struct aob_paper_outcome *outcome, struct aob_text *reason)

/* False after one line if a case is missing or not ok. */
MEASURE(aob_paper_alchemy_samples);
MEASURE(aob_paper_alchemy_filter);
MEASURE(aob_paper_alchemy_radius);
MEASURE(aob_paper_alchemy_distance);
MEASURE(aob_paper_alchemy_lod);
MEASURE(aob_paper_alchemy_field);
MEASURE(aob_paper_alchemy_guard);
MEASURE(aob_paper_alchemy_volumetric);
MEASURE(aob_paper_alchemy_floating);
MEASURE(aob_paper_alchemy_dragon);
MEASURE(aob_paper_alchemy_epsilon);
MEASURE(aob_paper_alchemy_beta);
MEASURE(aob_paper_hbao_samples);
MEASURE(aob_paper_hbao_blur);
MEASURE(aob_paper_hbao_half);
MEASURE(aob_paper_hbao_half_ao);
MEASURE(aob_paper_crytek_half);
MEASURE(aob_paper_starcraft2_blur);
MEASURE(aob_paper_gtao_error);
MEASURE(aob_paper_gtao_half);
MEASURE(aob_paper_aov_solid);
MEASURE(aob_paper_aov_thin);

WHY(aob_paper_alchemy_samples_why);
WHY(aob_paper_alchemy_filter_why);
WHY(aob_paper_alchemy_volumetric_why);
WHY(aob_paper_alchemy_epsilon_why);
WHY(aob_paper_alchemy_beta_why);
WHY(aob_paper_hbao_samples_why);
WHY(aob_paper_hbao_half_why);
WHY(aob_paper_crytek_half_why);
WHY(aob_paper_starcraft2_blur_why);
WHY(aob_paper_gtao_error_why);
WHY(aob_paper_gtao_half_why);
#endif
