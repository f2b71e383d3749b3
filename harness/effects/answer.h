/* The plan of effects for one view: what is known of each set, and which one is taken. */
#ifndef AOB_EFFECTS_ANSWER_H
#define AOB_EFFECTS_ANSWER_H
#include "bound.h"
#include "drawn.h"

/* What is asked. A set is within the tolerance if its error is at most that much above the least error of any set, and its flicker above
 * the least flicker. */
struct aob_effect_ask {
    double tolerance;    /* 0..1, of lit_rmse; NAN: AOB_EFFECT_TOLERANCE, or none where there is a budget */
    double budget_ms;    /* of a frame; INFINITY: no budget */
    const char *profile; /* on which times are modelled; NULL: those of this device */
};
/* A step of an 8-bit sRGB image at middle grey is 1.9 % of the light. */
#define AOB_EFFECT_TOLERANCE 0.02

struct aob_effect_candidate {
    unsigned set;
    struct aob_lit_error error;
    double
        flicker; /* over a sequence, of visibility (score/flicker.h), 0..1: a share of an open surface's light, as the error is; NAN: of a
                  * picture */
    double
        loss; /* set by the choice: how far error or flicker lies above the least of all sets, the larger of both */
    double ms;
    bool drawn;  /* its own frame was timed; else its passes are from other frames */
    bool within; /* the tolerance */
    bool fits;   /* the budget */
};
enum aob_effect_why { AOB_WHY_MEASURED, AOB_WHY_RULE, AOB_WHY_NO_DATA, AOB_WHY_BUDGET };

struct aob_effect_answer { /* zero it first */
    struct aob_effect_ask ask;
    struct aob_effect_bounds bounds;
    unsigned open; /* the effects that no rule took out */
    struct aob_effect_candidate candidates[AOB_EFFECT_SETS];
    size_t count;
    int frames; /* of the view's sequence, if something moves in it; 0: it is a picture, or stands still */
    const char *
        no_sequence; /* why frames before this one are not looked at, to stand behind "not known: "; NULL: they are */
    double most; /* loss that a set may have to be taken */
    int least;   /* candidate of the least error */
    int chosen;  /* candidate; -1: none fits the budget */
    int shrink;  /* pixels a side that became one for FLIP */
    /* Of a capture: there is no truth, and errors are against its own image of full size with the effects of `reference`. */
    bool no_truth;
    unsigned reference, materials; /* materials: bits AOB_MATERIAL_BIT of what its file has */
    unsigned lacks;                /* effects that depend on what it has not */
    bool unlit;                    /* so its frames have no lit image of the device's */
};

/* The tolerance that counts: 0.001 where there is a budget and no tolerance is asked for, which is a tie. */
double aob_effect_ask_tolerance(const struct aob_effect_ask *ask);

/* Judges the candidates, and takes the cheapest within the tolerance that fits the budget, and of those as dear to 2 % the one of the least
 * loss; where none does, likewise of those within a tie (0.001) of the least loss that fits. */
void aob_effect_answer_choose(struct aob_effect_answer *answer);

/* The candidate with just this set; NULL: it was not looked at. */
const struct aob_effect_candidate *aob_effect_answer_find(const struct aob_effect_answer *answer,
                                                          unsigned set);

/* A candidate as good as the chosen one: its loss is one that may be taken too, and it is as dear to 2 %. */
bool aob_effect_answer_ties(const struct aob_effect_answer *answer,
                            const struct aob_effect_candidate *candidate);

/* The chosen set with an effect turned about: taken out where it is in, else put in. Bent normal and directional light take
 * each other's place. */
unsigned aob_effect_turned(unsigned set, enum aob_effect_id id);

/* Why an effect is in the chosen set, or is not. */
enum aob_effect_why aob_effect_answer_why(const struct aob_effect_answer *answer, enum aob_effect_id id);

/* Adds a sentence with its number: whether the effect is called for, and why. */
void aob_effect_answer_explain(const struct aob_effect_answer *answer, enum aob_effect_id id,
                               struct aob_text *text);
#endif
