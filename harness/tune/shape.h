/* The config of a stage of a fit: that of the user with one technique, one target, one size and one value for each option. */
#ifndef AOB_TUNE_SHAPE_H
#define AOB_TUNE_SHAPE_H
#include "run/sweep.h"
#include "tune.h"

struct aob_tune_shape {
    struct aob_tune_setting *settings; /* count of them, one entry for each and each side of `sides` */
    size_t count;
    bool sides[AOB_TUNE_SIDES];
    int divisor; /* of the size, the guard band and what is in pixels; 1: none */
    int spp;     /* rays a pixel, at most; even */
    bool time;   /* frames are timed, if the config's are or there is a budget */
    bool error;  /* images are compared with the truth */
};

/* Reads the config anew and expands its plan. False after a line; the sweep is to be finished either way, and must stay where it is. */
bool aob_tune_shape_expand(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                           const struct aob_tune_shape *shape, struct aob_sweep *sweep,
                           struct aob_error *error);

/* Reads it with the views that are held out behind, and what else a fit takes as it is: the first size, backend and values of options, and
 * its entries of the technique, or one without a value where it has none. */
bool aob_tune_shape_read(const struct aob_tune_desc *desc, struct aob_config *config, bool **held,
                         struct aob_error *error);
#endif
