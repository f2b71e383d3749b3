/* A mesh compressed by Draco, for tests of what reads it. */
#ifndef AOB_TESTS_DRACO_PACK_H
#define AOB_TESTS_DRACO_PACK_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

/* The positions are attribute 0. Returns how many bytes it wrote into `bytes`, which has room for `room`; 0: it does not
 * fit. Without quantisation, so positions come back to the bit, though in another order. */
size_t draco_pack(const float (*positions)[3], uint32_t vertex_count, const uint32_t (*triangles)[3],
                  uint32_t triangle_count, char *bytes, size_t room);

#ifdef __cplusplus
}
#endif
#endif
