#include "simulate.h"

static bool begin(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error)
{
    const struct aob_trace_fan *fan = self;
    for (size_t i = 0; i < fan->count; i++)
        if (!fan->sinks[i].begin(fan->sinks[i].self, frame, pass, error))
            return false;
    return true;
}

static bool band(void *self, const struct aob_trace_band *rows, struct aob_error *error)
{
    const struct aob_trace_fan *fan = self;
    for (size_t i = 0; i < fan->count; i++)
        if (!fan->sinks[i].band(fan->sinks[i].self, rows, error))
            return false;
    return true;
}

static bool end(void *self, struct aob_error *error)
{
    const struct aob_trace_fan *fan = self;
    for (size_t i = 0; i < fan->count; i++)
        if (!fan->sinks[i].end(fan->sinks[i].self, error))
            return false;
    return true;
}

struct aob_trace_sink aob_trace_fan_sink(struct aob_trace_fan *fan)
{
    return (struct aob_trace_sink){fan, begin, band, end};
}
