/*
 * Chooses the loops over joints and rotations when the program is loaded. Those
 * in assembly compute with short vectors, which the VFP of ARM11 cores has.
 * Most later cores have a VFP without them and get the same loops in C.
 */
#include "app/anim/joints.h"
#include "app/anim/turns.h"
#include "platform/base/compiler.h"

enum {
	HWCAP_VFPV3 = 1 << 13 /* of <asm/hwcap.h> */
};

#define CHOOSE(name)                                                       \
	extern TYPE_OF(name) name##_vfp, name##_c;                         \
	static POINTER_TO(name) choose_##name(unsigned long capabilities)  \
	{                                                                  \
		return capabilities & HWCAP_VFPV3 ? name##_c : name##_vfp; \
	}                                                                  \
	TYPE_OF(name) name CHOSEN_BY("choose_" #name);

CHOOSE(joints_to_matrices)
CHOOSE(joints_multiply)
CHOOSE(turns_set)
CHOOSE(turns_mix)
CHOOSE(turns_set_packed)
CHOOSE(turns_mix_packed)
