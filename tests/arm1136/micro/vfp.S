#include "tests/arm1136/micro/cases.h"

	/* VFP11 manual, table 4.17 and sections 4.4 to 4.10. */
	.macro CLEAR
	mov r12, #0
	.irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
	fmsr s\n, r12
	.endr
	.irp n, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31
	fmsr s\n, r12
	.endr
	.rept 8
	mov r12, #0
	.endr
	.endm

	/* Each waits for the result before, which takes 8: 3 x 8 + 1. */
	CASE fmacs_chain, 25
	CLEAR
	BEGIN
	.rept 4
	fmacs s0, s16, s17
	.endr
	END

	CASE fmacs_independent, 16
	CLEAR
	BEGIN
	.rept 2
	.irp n, 0, 1, 2, 3, 4, 5, 6, 7
	fmacs s\n, s16, s17
	.endr
	.endr
	END

	CASE fmuls_to_fadds, 9
	CLEAR
	BEGIN
	fmuls s0, s16, s17
	fadds s1, s0, s18
	END

	/* VFP results are not forwarded to a store. */
	CASE fadds_to_fsts, 10
	CLEAR
	BEGIN
	fadds s0, s16, s17
	fsts s0, [r0]
	END

	CASE flds_to_fadds, 5
	CLEAR
	BEGIN
	flds s0, [r0]
	fadds s1, s0, s16
	END

	/* Loads run beside arithmetic. */
	CASE flds_beside_fmacs, 8
	CLEAR
	BEGIN
	fmacs s0, s16, s17
	flds s20, [r0]
	fmacs s1, s16, s17
	flds s21, [r0]
	fmacs s2, s16, s17
	flds s22, [r0]
	fmacs s3, s16, s17
	flds s23, [r0]
	END

	/* FLDM of 8: 4 memory cycles, the last after 4 + 3. */
	CASE fldm8_to_last, 8
	CLEAR
	BEGIN
	fldmias r0, {s0-s7}
	fadds s16, s7, s17
	END

	CASE fldm8_pipe, 5
	CLEAR
	BEGIN
	fldmias r0, {s0-s7}
	flds s16, [r0]
	END

	CASE fldd_unaligned_pipe, 7
	CLEAR
	BEGIN
	.irp n, 0, 1, 2, 3
	fldd d\n, [r0, #4]
	.endr
	END

	CASE fmuld_independent, 7
	CLEAR
	BEGIN
	.irp n, 0, 1, 2, 3
	fmuld d\n, d8, d9
	.endr
	END

	CASE faddd_chain, 25
	CLEAR
	BEGIN
	.rept 4
	faddd d0, d0, d9
	.endr
	END

	CASE fdivs_independent, 16
	CLEAR
	BEGIN
	fdivs s0, s16, s17
	fdivs s1, s16, s17
	END

	CASE fdivs_chain, 20
	CLEAR
	BEGIN
	fdivs s0, s16, s17
	fdivs s0, s0, s17
	END

	CASE fdivs_beside_fmacs, 9
	CLEAR
	BEGIN
	fdivs s0, s16, s17
	.irp n, 1, 2, 3, 4, 5, 6, 7, 8
	fmacs s\n, s16, s17
	.endr
	END

	CASE fmsr_to_fadds, 5
	CLEAR
	BEGIN
	fmsr s0, r2
	fadds s1, s0, s16
	END

	CASE fmrs_to_alu, 3
	CLEAR
	BEGIN
	fmrs r2, s0
	add r3, r2, r4
	END

	CASE fcpys_to_fadds, 5
	CLEAR
	BEGIN
	fcpys s0, s16
	fadds s1, s0, s17
	END

	/* FCMPS takes 4 and is not forwarded; then FMSTAT takes 2. */
	CASE fcmps_to_condition, 8
	CLEAR
	BEGIN
	fcmps s0, s16
	fmstat
	movmi r2, #1
	END

	/* A short vector issues once and occupies the pipeline for its length. */
	CASE vector4_pipe, 9
	CLEAR
	VECTOR 4
	BEGIN
	fmacs s8, s16, s24
	fmacs s12, s16, s24
	fmacs s0, s1, s2
	END

	CASE vector8_pipe, 9
	CLEAR
	VECTOR 8
	BEGIN
	fmacs s8, s16, s24
	fmacs s0, s1, s2
	END

	CASE vector4_beside_alu, 5
	CLEAR
	VECTOR 4
	BEGIN
	fmacs s8, s16, s24
	.rept 3
	add r2, r2, #1
	.endr
	fmacs s12, s16, s24
	END

	/* A vector waits for the registers of all iterations: 3 + 8. */
	CASE vector4_chain, 12
	CLEAR
	VECTOR 4
	BEGIN
	fmacs s8, s16, s24
	fmacs s8, s16, s24
	END

	/* An operand in the first bank is a scalar for all iterations. */
	CASE vector4_times_scalar, 5
	CLEAR
	VECTOR 4
	BEGIN
	fmuls s8, s16, s0
	fmuls s12, s20, s1
	END

	/* A load waits for an operation that still reads its register. */
	CASE vector8_operand_lock, 9
	CLEAR
	VECTOR 8
	BEGIN
	fmacs s8, s16, s24
	flds s31, [r0]
	END

	/* With a destination in the first bank, LEN does not matter. */
	CASE vector4_scalar_bank, 4
	CLEAR
	VECTOR 4
	BEGIN
	.irp n, 0, 1, 2, 3
	fmacs s\n, s16, s24
	.endr
	END
