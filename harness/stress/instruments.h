/* The properties of the program's own instruments, by instrument; instruments.c has their table. */
#ifndef AOB_STRESS_INSTRUMENTS_H
#define AOB_STRESS_INSTRUMENTS_H
#include "trial.h"

/* The tracer (instrument_tracer.c). */
void aob_ask_tracer_plane(struct aob_trial *trial);
void aob_ask_tracer_ball(struct aob_trial *trial);
void aob_ask_tracer_box(struct aob_trial *trial);
void aob_ask_tracer_corner(struct aob_trial *trial);
void aob_ask_tracer_wall(struct aob_trial *trial);
void aob_ask_tracer_sheet(struct aob_trial *trial);
void aob_ask_tracer_disc(struct aob_trial *trial);
void aob_ask_tracer_bent(struct aob_trial *trial);
void aob_ask_tracer_radius(struct aob_trial *trial);
void aob_ask_tracer_occluder(struct aob_trial *trial);
void aob_ask_tracer_scaled(struct aob_trial *trial);
void aob_ask_tracer_moved(struct aob_trial *trial);

/* The caches (instrument_cache.c). */
void aob_ask_cache_inclusion(struct aob_trial *trial);
void aob_ask_cache_cold(struct aob_trial *trial);
void aob_ask_cache_one_line(struct aob_trial *trial);
void aob_ask_cache_plain(struct aob_trial *trial);
void aob_ask_cache_paths(struct aob_trial *trial);
void aob_ask_cache_stack(struct aob_trial *trial);

/* The device model (instrument_model.c). */
void aob_ask_model_clock(struct aob_trial *trial);
void aob_ask_model_work(struct aob_trial *trial);
void aob_ask_model_resources(struct aob_trial *trial);
void aob_ask_model_ends(struct aob_trial *trial);

/* The statistics of times (instrument_statistics.c). */
void aob_ask_times_unit(struct aob_trial *trial);
void aob_ask_times_order(struct aob_trial *trial);
void aob_ask_times_identical(struct aob_trial *trial);
void aob_ask_times_level(struct aob_trial *trial);
void aob_ask_times_student(struct aob_trial *trial);
void aob_ask_times_median(struct aob_trial *trial);
void aob_ask_times_coverage(struct aob_trial *trial);
#endif
