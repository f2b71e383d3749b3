#include "bound_mesh.h"
#include "base/memory.h"

enum { CORNERS = 4 };
static const int corner_x[CORNERS] = {0, 1, 1, 0}, corner_y[CORNERS] = {0, 0, 1, 1};

/* Joined neighbours may leave each other's tangent plane by so many pixel widths. A smaller limit tears the surface
 * at its creases; a larger one joins what lies behind an edge to what lies before it. */
static const double join_limit = 2;

/* Walls against the sky end at so many farthest depths of the view. */
static const double end_ratio = 4;

struct rebuild {
    const struct aob_camera *camera;
    const struct aob_projection *projection;
    const struct aob_hits *hits;
    const struct aob_bound_desc *desc;
    struct aob_frame_axes axes;
    double end;
    struct aob_mesh *mesh;
};

/* An image position on the surface. Pixel centres are at whole numbers plus one half. */
struct place {
    double x, y, depth;
};

/* A cell between four pixel centres. Side k joins corner k to the next. */
struct cell {
    struct place corner[CORNERS]; /* depth 0: sky, or outside */
    size_t pixel[CORNERS];
    bool joined[CORNERS];
    struct place before[CORNERS], after[CORNERS]; /* of a quarter: on the sides k-1 and k */
    struct place middle[CORNERS];                 /* of a quarter: in the cell's middle */
};

static int next_corner(int k)
{
    return (k + 1) % CORNERS;
}

static bool is_seen(const struct cell *cell, int k)
{
    return cell->corner[k].depth > 0;
}

static struct aob_vec3 view_point(const struct rebuild *r, struct place p)
{
    double scale = r->projection->perspective ? p.depth : 1;
    return aob_vec((p.x - r->projection->cx) * r->projection->sx * scale,
                   (r->projection->cy - p.y) * r->projection->sy * scale, -p.depth);
}

static struct aob_vec3 world_point(const struct rebuild *r, struct place p)
{
    struct aob_vec3 v = view_point(r, p);
    return aob_vec_add(aob_vec_add(r->camera->eye, aob_vec_scale(r->axes.right, v.x)),
                       aob_vec_add(aob_vec_scale(r->axes.up, v.y), aob_vec_scale(r->axes.back, v.z)));
}

static struct aob_vec3 view_normal(const struct rebuild *r, size_t pixel)
{
    const float *n = r->hits->normal[pixel];
    return aob_vec(n[0], n[1], n[2]);
}

/* On a plane this is linear over the image: 1 / depth in a perspective view. */
static double mean_depth(const struct rebuild *r, double a, double b)
{
    return r->projection->perspective ? 2 / (1 / a + 1 / b) : (a + b) / 2;
}

static double clamp(double value, double low, double high)
{
    return value < high ? fmax(value, low) : high;
}

/* The depth of corner k's tangent plane at (x, y). A plane that never gets there counts as endlessly far. */
static double plane_depth(const struct rebuild *r, const struct cell *cell, int k, double x, double y)
{
    struct place at = cell->corner[k], one = {x, y, 1};
    struct aob_vec3 n = view_normal(r, cell->pixel[k]), p = view_point(r, at);
    if (r->projection->perspective) {
        double depth = aob_vec_dot(n, p) / aob_vec_dot(n, view_point(r, one));
        return depth > 0 ? depth : INFINITY;
    }
    one.depth = at.depth;
    double depth = at.depth + aob_vec_dot(n, aob_vec_sub(view_point(r, one), p)) / n.z;
    return isnan(depth) ? INFINITY : depth;
}

static bool are_joined(const struct rebuild *r, const struct cell *cell, int a, int b)
{
    if (!is_seen(cell, a) || !is_seen(cell, b))
        return false;
    struct aob_vec3 d = aob_vec_sub(view_point(r, cell->corner[b]), view_point(r, cell->corner[a]));
    double nearer = fmin(cell->corner[a].depth, cell->corner[b].depth);
    double width = r->projection->sx * (r->projection->perspective ? nearer : 1);
    double off = fmax(fabs(aob_vec_dot(d, view_normal(r, cell->pixel[a]))),
                      fabs(aob_vec_dot(d, view_normal(r, cell->pixel[b]))));
    return off <= join_limit * width;
}

static void cell_init(const struct rebuild *r, int x, int y, struct cell *cell)
{
    for (int k = 0; k < CORNERS; k++) {
        int px = x + corner_x[k], py = y + corner_y[k];
        cell->pixel[k] = (size_t)py * (size_t)r->hits->width + (size_t)px;
        cell->corner[k] = (struct place){px + 0.5, py + 0.5, r->hits->depth[cell->pixel[k]]};
    }
    for (int k = 0; k < CORNERS; k++)
        cell->joined[k] = are_joined(r, cell, k, next_corner(k));
}

/* The middle of the side from corner k to corner `other`, as k sees it. */
static struct place side_middle(const struct rebuild *r, const struct cell *cell, int k, int other)
{
    struct place a = cell->corner[k], b = cell->corner[other];
    struct place middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, 0};
    bool joined = next_corner(k) == other ? cell->joined[k] : cell->joined[other];
    double low = is_seen(cell, other) ? fmin(a.depth, b.depth) : a.depth / 2;
    double high = is_seen(cell, other) ? fmax(a.depth, b.depth) : a.depth * 2;
    middle.depth = joined ? mean_depth(r, a.depth, b.depth)
                          : clamp(plane_depth(r, cell, k, middle.x, middle.y), low, high);
    return middle;
}

/* Corners that are joined, directly or through others, get the same number. */
static void find_groups(const struct cell *cell, int group[CORNERS])
{
    for (int k = 0; k < CORNERS; k++)
        group[k] = k;
    for (int turn = 0; turn < 2 * CORNERS; turn++) {
        int a = turn % CORNERS, b = next_corner(a);
        int low = group[a] < group[b] ? group[a] : group[b];
        if (cell->joined[a])
            group[a] = group[b] = low;
    }
}

/* The depths that each corner's plane may reach in the middle of the cell. */
static void depth_range(const struct cell *cell, double *low, double *high)
{
    bool sky = false;
    *low = INFINITY;
    *high = 0;
    for (int k = 0; k < CORNERS; k++) {
        sky |= !is_seen(cell, k);
        if (is_seen(cell, k))
            *low = fmin(*low, cell->corner[k].depth);
        *high = fmax(*high, cell->corner[k].depth);
    }
    *low /= sky ? 2 : 1;
    *high *= sky ? 2 : 1;
}

static void find_middles(const struct rebuild *r, struct cell *cell)
{
    int group[CORNERS];
    double low, high, x = cell->corner[0].x + 0.5, y = cell->corner[0].y + 0.5, depth[CORNERS];
    find_groups(cell, group);
    depth_range(cell, &low, &high);
    for (int k = 0; k < CORNERS; k++)
        depth[k] = is_seen(cell, k) ? clamp(plane_depth(r, cell, k, x, y), low, high) : 0;
    for (int k = 0; k < CORNERS; k++) {
        double sum = 0, count = 0;
        for (int i = 0; i < CORNERS; i++) {
            sum += group[i] == group[k] ? depth[i] : 0;
            count += group[i] == group[k];
        }
        cell->middle[k] = (struct place){x, y, sum / count};
    }
}

static uint32_t add_place(const struct rebuild *r, struct place p)
{
    return aob_mesh_add_vertex(r->mesh, world_point(r, p));
}

static void add_quad(const struct rebuild *r, const struct place p[CORNERS])
{
    uint32_t a = add_place(r, p[0]), b = add_place(r, p[1]), c = add_place(r, p[2]), d = add_place(r, p[3]);
    aob_mesh_add_triangle(r->mesh, a, b, c);
    aob_mesh_add_triangle(r->mesh, a, c, d);
}

static struct place back_of(const struct rebuild *r, struct place p)
{
    p.depth = fmin(p.depth + r->desc->thickness, r->end);
    return p;
}

static void add_back(const struct rebuild *r, const struct place p[CORNERS])
{
    if (r->desc->kind != AOB_BOUND_SLAB)
        return;
    struct place back[CORNERS];
    for (int k = 0; k < CORNERS; k++)
        back[k] = back_of(r, p[k]);
    add_quad(r, back);
}

static void add_whole(const struct rebuild *r, const struct cell *cell)
{
    const struct place *c = cell->corner;
    bool turn = mean_depth(r, c[1].depth, c[3].depth) > mean_depth(r, c[0].depth, c[2].depth);
    uint32_t v[CORNERS];
    struct place p[CORNERS];
    for (int k = 0; k < CORNERS; k++) {
        int from = (k + turn) % CORNERS;
        v[k] = (uint32_t)cell->pixel[from];
        p[k] = c[from];
    }
    aob_mesh_add_triangle(r->mesh, v[0], v[1], v[2]);
    aob_mesh_add_triangle(r->mesh, v[0], v[2], v[3]);
    add_back(r, p);
}

/* How far a wall at `p` has to go so that no ray gets in behind it. It ends at `other`, because what lies behind that
 * is solid too. */
static struct place wall_foot(const struct rebuild *r, struct place p, const struct place *other)
{
    if (r->desc->kind == AOB_BOUND_SLAB)
        return back_of(r, p);
    p.depth = other ? fmax(p.depth, other->depth) : r->end;
    return p;
}

/* Adds the wall of corner k along the cut of its side towards `other`. */
static void add_wall(const struct rebuild *r, const struct cell *cell, int k, int other, struct place side,
                     struct place other_side)
{
    bool open = !is_seen(cell, other);
    const struct place wall[CORNERS] = {
        side,
        cell->middle[k],
        wall_foot(r, cell->middle[k], open ? NULL : &cell->middle[other]),
        wall_foot(r, side, open ? NULL : &other_side),
    };
    add_quad(r, wall);
}

static void add_cut(const struct rebuild *r, struct cell *cell)
{
    find_middles(r, cell);
    for (int k = 0; k < CORNERS; k++) {
        int next = next_corner(k);
        if (is_seen(cell, k))
            cell->after[k] = side_middle(r, cell, k, next);
        if (is_seen(cell, next))
            cell->before[next] = side_middle(r, cell, next, k);
    }
    for (int k = 0; k < CORNERS; k++) {
        int next = next_corner(k);
        const struct place quarter[CORNERS] = {cell->corner[k], cell->after[k], cell->middle[k],
                                               cell->before[k]};
        if (is_seen(cell, k)) {
            add_quad(r, quarter);
            add_back(r, quarter);
        }
        if (cell->joined[k])
            continue;
        if (is_seen(cell, k))
            add_wall(r, cell, k, next, cell->after[k], cell->before[next]);
        if (is_seen(cell, next))
            add_wall(r, cell, next, k, cell->before[next], cell->after[k]);
    }
}

static void add_cell(const struct rebuild *r, int x, int y)
{
    struct cell cell;
    cell_init(r, x, y, &cell);
    if (cell.joined[0] && cell.joined[1] && cell.joined[2] && cell.joined[3])
        add_whole(r, &cell);
    else if (r->desc->kind != AOB_BOUND_THIN)
        add_cut(r, &cell);
}

/* A sky pixel gets a vertex inside the bounds, so that the other pixels keep their numbers. */
static void add_pixels(const struct rebuild *r)
{
    size_t width = (size_t)r->hits->width, pixels = width * (size_t)r->hits->height;
    for (size_t i = 0; i < pixels; i++) {
        double depth = r->hits->depth[i] > 0 ? r->hits->depth[i] : r->end;
        struct place p = {(double)(i % width) + 0.5, (double)(i / width) + 0.5, depth};
        uint32_t v = add_place(r, p);
        aob_mesh_add_triangle(r->mesh, v, v, v);
    }
}

static void add_bounds(const struct rebuild *r)
{
    for (int k = 0; k < CORNERS; k++) {
        struct place p = {corner_x[k] * r->hits->width, corner_y[k] * r->hits->height, 0};
        add_place(r, p);
        p.depth = r->end;
        add_place(r, p);
    }
}

static void count_quads(struct aob_bound_size *size, size_t quads)
{
    size->vertices += CORNERS * quads;
    size->triangles += 2 * quads;
}

/* As add_cell adds it: a whole cell takes the pixels' own vertices, all else has quads of its own. */
static void count_cell(const struct rebuild *r, int x, int y, struct aob_bound_size *size)
{
    struct cell cell;
    bool slab = r->desc->kind == AOB_BOUND_SLAB;
    cell_init(r, x, y, &cell);
    if (cell.joined[0] && cell.joined[1] && cell.joined[2] && cell.joined[3]) {
        size->triangles += 2;
        count_quads(size, slab);
        return;
    }
    for (int k = 0; k < CORNERS && r->desc->kind != AOB_BOUND_THIN; k++) {
        bool seen = is_seen(&cell, k);
        count_quads(size, seen && slab ? 2 : seen);
        if (!cell.joined[k])
            count_quads(size, (size_t)seen + is_seen(&cell, next_corner(k)));
    }
}

struct aob_bound_size aob_bound_mesh_size(const struct aob_camera *camera,
                                          const struct aob_projection *projection,
                                          const struct aob_hits *hits, const struct aob_bound_desc *desc)
{
    struct rebuild r = {camera, projection, hits, desc, aob_camera_axes(camera), 0, NULL};
    size_t pixels = (size_t)hits->width * (size_t)hits->height;
    struct aob_bound_size size = {pixels + 2 * CORNERS, pixels};
    for (int y = 0; y + 1 < hits->height; y++)
        for (int x = 0; x + 1 < hits->width; x++)
            count_cell(&r, x, y, &size);
    return size;
}

bool aob_bound_mesh(const struct aob_camera *camera, const struct aob_projection *projection,
                    const struct aob_hits *hits, const struct aob_bound_desc *desc, struct aob_mesh *mesh)
{
    struct rebuild r = {camera, projection, hits, desc, aob_camera_axes(camera), 0, mesh};
    size_t pixels = (size_t)hits->width * (size_t)hits->height;
    for (size_t i = 0; i < pixels; i++)
        r.end = fmax(r.end, end_ratio * hits->depth[i]);
    if (!(r.end > 0))
        return false;
    add_pixels(&r);
    add_bounds(&r);
    for (int y = 0; y + 1 < hits->height; y++)
        for (int x = 0; x + 1 < hits->width; x++)
            add_cell(&r, x, y);
    return true;
}
