/*
 * What the parts of the library share: faults.c counts calls and knows which
 * one fails; fault_memory.c, fault_files.c and fault_streams.c replace
 * functions; fault_sites.c knows where calls come from.
 */
#ifndef TESTS_FAULTS_FAULTS_H
#define TESTS_FAULTS_FAULTS_H

#define _GNU_SOURCE

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

enum kind {
	ALLOC,
	OPEN,
	STAT,
	READ,
	READ_SHORT,
	WRITE,
	WRITE_SHORT,
	FSYNC,
	CLOSE,
	RENAME,
	MMAP,
	IOCTL,
	THREAD,
	LIBRARY,
	KINDS
};

/* Counts a call; whether it shall fail. */
bool faults_next_fails(enum kind kind);

/* From here on notes where calls come from: chains of so many of its frames. */
void faults_watch_sites(int frames, const void *in_program);

/* Notes where a call comes from. */
void faults_note_site(enum kind kind, long number);

/* Writes " NUMBER:HASH" for each site: the first call from there. */
void faults_write_sites(FILE *report, enum kind kind);

/* What may still be written to the disk; -1: any amount. */
extern long faults_disk_bytes;

/* open(), counted, for all functions that open files. */
int faults_open(int folder, const char *path, int flags, mode_t mode);

/* A stream that reads and writes through the replaced functions. */
FILE *faults_open_stream(const char *path, const char *mode);

/* Makes standard output such a stream. */
void faults_watch_stdout(void);

/* Lets only allocations and libraries that the program itself asks for count. */
void faults_watch_program(void);

/* Whether an allocation or a library that this caller asks for counts. */
bool faults_watches(const void *caller);

/* Begins a replacement of a function: next is what it forwards to. */
#define FAULTS_NEXT(name)                                  \
	static __typeof__(name) *next;                     \
	if (!next) {                                       \
		*(void **)&next = dlsym(RTLD_NEXT, #name); \
	}

#endif
