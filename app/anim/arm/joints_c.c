/* The loops of ../portable/joints.c under names that end in _c, for choose.c. */
#define joints_to_matrices joints_to_matrices_c
#define joints_multiply    joints_multiply_c

#include "app/anim/portable/joints.c"
