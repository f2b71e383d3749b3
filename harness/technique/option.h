/* Run options: the same for every technique, written like parameters (`-p fetch=storage`, `options:`). */
#ifndef AOB_TECHNIQUE_OPTION_H
#define AOB_TECHNIQUE_OPTION_H
#include <aobudget/technique.h>

struct aob_options {
    int32_t guard_band; /* pixels rendered around the view and cropped before scoring */
    int32_t fetch;      /* enum aob_fetch */
    int32_t threads;    /* of a software driver; 0: the driver's default */
};
enum aob_fetch { AOB_FETCH_SAMPLED, AOB_FETCH_STORAGE };
enum { AOB_OPTION_COUNT = 3 };

extern const struct aob_param aob_option_params[AOB_OPTION_COUNT];
#endif
