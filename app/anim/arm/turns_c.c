/* The loops of ../portable/turns.c under names that end in _c, for choose.c. */
#define turns_set        turns_set_c
#define turns_mix        turns_mix_c
#define turns_set_packed turns_set_packed_c
#define turns_mix_packed turns_mix_packed_c

#include "app/anim/portable/turns.c"
