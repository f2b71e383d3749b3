/* A set in one or two registers. The lines before the one that is found, or all where it is not, move one place back:
 * `shifted` is the whole set moved, and a mask says how far down it holds. */
#include "tags_kernel.h"

#if defined(__x86_64__)
#include <immintrin.h>

/* Loaded from 15 - p on, the lanes up to p are ones. */
static const int32_t window[32] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

__attribute__((target("sse4.1"))) static size_t access_sse41(uint32_t *tags, uint32_t ways,
                                                             const struct aob_tags_accesses *accesses)
{
    uint32_t last = 1u << (ways - 1), *missed = accesses->missed;
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        __m128i *set = (__m128i *)(void *)(tags + 4 * (size_t)accesses->sets[i]);
        __m128i held = _mm_loadu_si128(set), line = _mm_set1_epi32((int)accesses->lines[i]);
        unsigned found = (unsigned)_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(held, line)));
        const int32_t *mask = window + 15 - __builtin_ctz(found | last);
        __m128i shifted = _mm_alignr_epi8(held, line, 12);
        _mm_storeu_si128(
            set, _mm_blendv_epi8(held, shifted, _mm_loadu_si128((const __m128i *)(const void *)mask)));
        missed[misses] = accesses->first + (uint32_t)i;
        misses += !found;
    }
    return misses;
}

__attribute__((target("avx2"))) static __m256i load8(const void *at)
{
    return _mm256_loadu_si256(at);
}

__attribute__((target("avx2"))) static unsigned equal8(__m256i a, __m256i b)
{
    return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)));
}

__attribute__((target("avx2"))) static size_t access_avx2(uint32_t *tags, uint32_t ways,
                                                          const struct aob_tags_accesses *accesses)
{
    const __m256i turn = _mm256_setr_epi32(7, 0, 1, 2, 3, 4, 5, 6);
    uint32_t last = 1u << (ways - 1), *missed = accesses->missed;
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        __m256i *set = (__m256i *)(void *)(tags + 8 * (size_t)accesses->sets[i]);
        __m256i held = load8(set), line = _mm256_set1_epi32((int)accesses->lines[i]);
        unsigned found = equal8(held, line);
        __m256i mask = load8(window + 15 - __builtin_ctz(found | last));
        __m256i shifted = _mm256_blend_epi32(_mm256_permutevar8x32_epi32(held, turn), line, 1);
        _mm256_storeu_si256(set, _mm256_blendv_epi8(held, shifted, mask));
        missed[misses] = accesses->first + (uint32_t)i;
        misses += !found;
    }
    return misses;
}

__attribute__((target("avx2"))) static size_t access_avx2_pair(uint32_t *tags, uint32_t ways,
                                                               const struct aob_tags_accesses *accesses)
{
    const __m256i turn = _mm256_setr_epi32(7, 0, 1, 2, 3, 4, 5, 6);
    uint32_t last = 1u << (ways - 1), *missed = accesses->missed;
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        __m256i *set = (__m256i *)(void *)(tags + 16 * (size_t)accesses->sets[i]);
        __m256i low = load8(set), high = load8(set + 1), line = _mm256_set1_epi32((int)accesses->lines[i]);
        unsigned found = equal8(low, line) | equal8(high, line) << 8;
        const int32_t *mask = window + 15 - __builtin_ctz(found | last);
        __m256i turned = _mm256_permutevar8x32_epi32(low, turn);
        __m256i next = _mm256_blend_epi32(_mm256_permutevar8x32_epi32(high, turn), turned, 1);
        _mm256_storeu_si256(set, _mm256_blendv_epi8(low, _mm256_blend_epi32(turned, line, 1), load8(mask)));
        _mm256_storeu_si256(set + 1, _mm256_blendv_epi8(high, next, load8(mask + 8)));
        missed[misses] = accesses->first + (uint32_t)i;
        misses += !found;
    }
    return misses;
}

__attribute__((target("avx512f,bmi"))) static size_t access_avx512(uint32_t *tags, uint32_t ways,
                                                                   const struct aob_tags_accesses *accesses)
{
    uint32_t last = 1u << (ways - 1), *missed = accesses->missed;
    size_t misses = 0;
    for (size_t i = 0; i < accesses->count; i++) {
        uint32_t *set = tags + 16 * (size_t)accesses->sets[i];
        __m512i held = _mm512_loadu_si512(set), line = _mm512_set1_epi32((int)accesses->lines[i]);
        unsigned found = _mm512_cmpeq_epi32_mask(held, line), stop = found | last;
        __mmask16 mask = (__mmask16)(stop ^ (stop - 1)); /* the lanes up to the lowest bit of `stop` */
        _mm512_storeu_si512(set, _mm512_mask_alignr_epi32(held, mask, held, line, 15));
        missed[misses] = accesses->first + (uint32_t)i;
        misses += !found;
    }
    return misses;
}

struct aob_tags_way aob_tags_simd(enum aob_tags_path path, uint32_t ways)
{
    if (path == AOB_TAGS_SSE41 && ways <= 4 && __builtin_cpu_supports("sse4.1"))
        return (struct aob_tags_way){access_sse41, 4};
    if (path == AOB_TAGS_AVX2 && ways <= 8 && __builtin_cpu_supports("avx2"))
        return (struct aob_tags_way){access_avx2, 8};
    if (path == AOB_TAGS_AVX2 && ways <= 16 && __builtin_cpu_supports("avx2"))
        return (struct aob_tags_way){access_avx2_pair, 16};
    if (path == AOB_TAGS_AVX512 && ways <= 16 && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("bmi"))
        return (struct aob_tags_way){access_avx512, 16};
    return (struct aob_tags_way){0};
}
#else
struct aob_tags_way aob_tags_simd(enum aob_tags_path path, uint32_t ways)
{
    (void)path;
    (void)ways;
    return (struct aob_tags_way){0};
}
#endif
