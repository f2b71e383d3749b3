/* Clearance: which parts of the image nothing can occlude, found by passes of the harness before a technique's, where the run
 * option `thrift` wants it. A pass that reads AOB_CLEARANCE then leaves those pixels out (aob_is_clear in technique.h).
 *
 * A tile of 8 x 8 pixels is clear if its surfaces lie in one plane, the G-buffer's normals are about that plane's, and nothing
 * that can darken the tile rises above it by more than the technique says that it may (struct aob_clearance). That is what lies
 * within the radius, or what is drawn where the ball of the radius is and lies in front, however far. What bounds the
 * surfaces of a tile, and of 4 x 4 tiles, is what two convex bodies have in common: the rays through its corners, cut by two
 * planes across its normal, and cut by its nearest and farthest depth. Depths alone would prove nothing on slanted floors, and
 * planes alone nothing where a tile is seen from the side. Threads: const data. */
#ifndef AOB_TECHNIQUE_CLEARANCE_H
#define AOB_TECHNIQUE_CLEARANCE_H
#include "graph.h"

enum { AOB_CLEARANCE_TILE = 8, AOB_CLEARANCE_GROUP = 32 };

/* What the technique says of these values; all 0 where it says nothing, or has no uniform parameter `radius`. */
struct aob_clearance aob_clearance_of(const struct aob_technique *technique, const void *values);

/* Lays the passes `clearance_tiles`, `clearance_groups` and `clearance`; graph->clear is the texture that they end in. It stays -1
 * where a share of what the technique says is below a millionth, and graph->unclear is then why, if the technique says that. False
 * after a line in graph->error. */
bool aob_clearance_lay(struct aob_pass_graph *graph, const void *values);

/* Adds what decides which pixels are clear besides the technique, for the key of cases that want thrift: the hash of the passes'
 * texts. */
void aob_clearance_identify(struct aob_text *text);
#endif
