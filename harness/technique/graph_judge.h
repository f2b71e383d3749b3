/* The second half of aob_graph_build: what build() laid out, judged as a whole. */
#ifndef AOB_TECHNIQUE_GRAPH_JUDGE_H
#define AOB_TECHNIQUE_GRAPH_JUDGE_H
#include "graph.h"

/* Finds which levels each input shows, and which passes and textures are live. False after a line in graph->error. */
bool aob_graph_judge(struct aob_pass_graph *graph);
#endif
