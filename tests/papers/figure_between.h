/* A figure with its interval, as an initialiser. */
#ifndef AOB_TESTS_PAPERS_FIGURE_BETWEEN_H
#define AOB_TESTS_PAPERS_FIGURE_BETWEEN_H
#define BETWEEN(v, low, high)                                                                                \
    {                                                                                                        \
        (v), (low), (high)                                                                                   \
    }
#endif
