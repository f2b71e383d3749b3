#include "chance.h"
#include <math.h>
#include <stdlib.h>
#include "base/hash.h"
#include "reference/sampler.h"

struct aob_chance aob_chance_of(const char *name)
{
    char key[AOB_KEY_SIZE];
    aob_hash_text(name, key);
    key[16] = '\0'; /* 64 bits of it */
    return (struct aob_chance){strtoull(key, NULL, 16), 0};
}

static uint64_t next(struct aob_chance *chance)
{
    return aob_sampler_mix(chance->key, chance->drawn++);
}

size_t aob_chance_below(struct aob_chance *chance, size_t n)
{
    return (size_t)((next(chance) >> 32) * (uint64_t)n >> 32);
}

bool aob_chance_once_in(struct aob_chance *chance, size_t n)
{
    return aob_chance_below(chance, n) == 0;
}

double aob_chance_unit(struct aob_chance *chance)
{
    return (double)(next(chance) >> 11) * 0x1p-53;
}

double aob_chance_between(struct aob_chance *chance, double low, double high)
{
    return low + (high - low) * aob_chance_unit(chance);
}

double aob_chance_log(struct aob_chance *chance, double low, double high)
{
    return low * pow(high / low, aob_chance_unit(chance));
}

struct aob_vec3 aob_chance_direction(struct aob_chance *chance)
{
    double z = aob_chance_between(chance, -1, 1), a = aob_chance_between(chance, 0, 2 * M_PI);
    double r = sqrt(1 - z * z);
    return aob_vec(r * cos(a), r * sin(a), z);
}
