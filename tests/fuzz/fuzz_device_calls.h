/*
 * Devices that answer anything, at the seams of limber's system calls: the
 * input decides what each call returns and what it writes.
 */
#ifndef TESTS_FUZZ_FUZZ_DEVICE_CALLS_H
#define TESTS_FUZZ_FUZZ_DEVICE_CALLS_H

#include "platform/camera/v4l2/v4l2_calls.h"
#include "platform/display/kms/kms_calls.h"
#include "platform/process/device_calls.h"

#include <stddef.h>
#include <stdint.h>

/* Makes the devices answer from these bytes, and from zeros after them. */
void fuzz_device_begin(const uint8_t *data, size_t size);

/* The next byte. */
unsigned int fuzz_device_byte(void);

/* The next four bytes as a number. */
uint32_t fuzz_device_word(void);

/* 0, or the errno of a call that fails, as one in eight does. */
int fuzz_device_fault(void);

/* The same as a result: 0, or -1 with errno set. */
int fuzz_device_failing(void);

/* Overwrites up to three words of a plausible answer. */
void fuzz_device_spoil(void *answer, size_t size);

/* Memory that a driver has to give back; NULL needs no release. */
void *fuzz_device_object(size_t size);
void fuzz_device_release(void *object);
void fuzz_device_count_objects(int change);

/* Ends the process unless everything that was opened or mapped is released. */
void fuzz_device_end(void);

extern const struct v4l2_calls fuzz_device_v4l2;
extern const struct device_calls fuzz_device_file;
extern const struct kms_calls fuzz_device_kms;
#endif
