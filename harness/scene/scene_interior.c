#include "scene_interior.h"

/* Counter-clockwise as seen from inside the room. */
static void corners_of(const struct aob_interior *room, enum aob_wall wall, struct aob_vec3 corners[4])
{
    struct aob_vec3 a = room->low, b = room->high, size = aob_vec_sub(b, a);
    struct aob_vec3 x = aob_vec(size.x, 0, 0), y = aob_vec(0, size.y, 0), z = aob_vec(0, 0, size.z);
    const struct {
        struct aob_vec3 corner, u, v;
    } walls[AOB_WALL_COUNT] = {
        {a, z, x}, {aob_vec(a.x, b.y, a.z), x, z}, {a, x, y}, {aob_vec(a.x, a.y, b.z), y, x},
        {a, y, z}, {aob_vec(b.x, a.y, a.z), z, y},
    };
    corners[0] = walls[wall].corner;
    corners[1] = aob_vec_add(corners[0], walls[wall].u);
    corners[2] = aob_vec_add(corners[1], walls[wall].v);
    corners[3] = aob_vec_add(corners[0], walls[wall].v);
}

static void add_face(struct aob_mesh *mesh, const struct aob_vec3 corners[4])
{
    uint32_t first = aob_mesh_add_vertex(mesh, corners[0]);
    for (int i = 1; i < 4; i++)
        aob_mesh_add_vertex(mesh, corners[i]);
    aob_mesh_add_triangle(mesh, first, first + 1, first + 2);
    aob_mesh_add_triangle(mesh, first, first + 2, first + 3);
}

void aob_interior_add_wall(struct aob_mesh *mesh, const struct aob_interior *room, enum aob_wall wall)
{
    struct aob_vec3 corners[4];
    corners_of(room, wall, corners);
    add_face(mesh, corners);
}

/* The hole's box brought into the plane of the wall. */
static struct aob_interior flatten(const struct aob_interior *room, enum aob_wall wall,
                                   const struct aob_interior *hole)
{
    struct aob_interior flat = *hole;
    if (wall == AOB_WALL_FLOOR || wall == AOB_WALL_CEILING) {
        flat.low.y = room->low.y;
        flat.high.y = room->high.y;
    } else if (wall == AOB_WALL_BACK || wall == AOB_WALL_FRONT) {
        flat.low.z = room->low.z;
        flat.high.z = room->high.z;
    } else {
        flat.low.x = room->low.x;
        flat.high.x = room->high.x;
    }
    return flat;
}

void aob_interior_add_opening(struct aob_mesh *mesh, const struct aob_interior *room, enum aob_wall wall,
                              const struct aob_interior *hole, double depth)
{
    struct aob_interior flat = flatten(room, wall, hole);
    struct aob_vec3 outer[4], inner[4];
    corners_of(room, wall, outer);
    corners_of(&flat, wall, inner);
    struct aob_vec3 in =
        aob_vec_normalize(aob_vec_cross(aob_vec_sub(outer[1], outer[0]), aob_vec_sub(outer[3], outer[0])));
    struct aob_vec3 out = aob_vec_scale(in, -depth);
    for (int i = 0; i < 4; i++) { /* from corner to corner, so that no vertex lies on another's edge */
        int next = (i + 1) % 4;
        const struct aob_vec3 part[4] = {outer[i], outer[next], inner[next], inner[i]};
        add_face(mesh, part);
        aob_mesh_add_quad(mesh, inner[i], aob_vec_sub(inner[next], inner[i]), out);
    }
}

void aob_interior_add_block(struct aob_mesh *mesh, struct aob_vec3 foot, struct aob_vec3 size,
                            double turn_y_deg)
{
    struct aob_vec3 low = aob_vec(foot.x - size.x / 2, foot.y, foot.z - size.z / 2);
    aob_mesh_add_box(mesh, low, aob_vec_add(low, size), turn_y_deg);
}

void aob_interior_add_table(struct aob_mesh *mesh, struct aob_vec3 low, struct aob_vec3 high,
                            double turn_y_deg)
{
    const double thick = 0.05, leg = 0.06, edge = 0.05;
    double turn = turn_y_deg * (M_PI / 180), top = high.y - thick;
    struct aob_vec3 centre = aob_vec_scale(aob_vec_add(low, high), 0.5);
    double dx = (high.x - low.x - leg) / 2 - edge, dz = (high.z - low.z - leg) / 2 - edge;
    aob_mesh_add_box(mesh, aob_vec(low.x, top, low.z), high, turn_y_deg);
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? dx : -dx, z = i / 2 ? dz : -dz;
        struct aob_vec3 foot = aob_vec(centre.x + x * cos(turn) + z * sin(turn), low.y,
                                       centre.z + z * cos(turn) - x * sin(turn));
        aob_interior_add_block(mesh, foot, aob_vec(leg, top - low.y, leg), turn_y_deg);
    }
}
