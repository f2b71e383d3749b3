/* What invocations execute, counted by the class of unit that takes it. A pass's are sums over all its invocations. */
#ifndef AOB_PROFILE_OPERATIONS_H
#define AOB_PROFILE_OPERATIONS_H

struct aob_operations {
    double alu; /* scalar slots at the full rate: one component of an addition, multiplication, comparison */
    double special; /* scalar ones of the unit for reciprocals, roots, powers, logarithms and sines */
    double image;   /* samples, fetches, reads and gathers: one each, whatever they return */
};
#endif
