/* The distance of segments, for parts that must not pass through each other. */
#ifndef APP_CHARACTER_PARTS_DISTANCE_H
#define APP_CHARACTER_PARTS_DISTANCE_H

/* Returns the shortest distance between the segments a-b and c-d. */
float character_line_distance(
	const float a[3], const float b[3], const float c[3], const float d[3]);

#endif
