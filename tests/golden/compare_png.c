/*
 * compare_png STEP FAR_PERCENT MEAN BLOCK_MEAN BLOCK_STRAYS
 *     REFERENCE PICTURE DIFFERENCE
 *
 * Prints how PICTURE differs from REFERENCE. The exit status is 0 within the
 * five tolerances (struct picture_tolerance), 1 beyond them, 2 for wrong usage.
 * Beyond them the program writes the PNG file DIFFERENCE, which shows both
 * pictures and their difference.
 */
#include "tests/support/gl/picture.h"

#include <stdio.h>
#include <stdlib.h>

static void keep_difference(const char *path, const struct picture *reference,
	const struct picture *picture)
{
	struct picture shown = picture_show_difference(reference, picture);

	if (shown.rgb && picture_write(path, &shown) == 0) {
		printf("reference, picture and difference: %s\n", path);
	}
	picture_release(&shown);
}

static int compare(const struct picture *reference,
	const struct picture *picture, const struct picture_tolerance *limit,
	const char *difference_path)
{
	struct picture_difference difference =
		picture_compare(reference, picture, limit->step);

	if (!difference.same_size) {
		printf("the picture is %dx%d, its reference %dx%d\n",
			picture->width, picture->height, reference->width,
			reference->height);
		return 1;
	}
	printf("%.3f %% of the pixels differ by more than %d (limit %g), ",
		difference.far_percent, limit->step, limit->far_percent);
	printf("mean %.3f (limit %g), worst block %.2f at %d,%d (limit %g), ",
		difference.mean, limit->mean, difference.block_mean,
		difference.block_x, difference.block_y, limit->block_mean);
	printf("strays of a block %d at %d,%d (limit %d), largest %d\n",
		difference.block_strays, difference.stray_x, difference.stray_y,
		limit->block_strays, difference.worst);
	if (picture_is_near(&difference, limit)) {
		return 0;
	}
	keep_difference(difference_path, reference, picture);
	return 1;
}

int main(int argc, char **argv)
{
	struct picture_tolerance limit;
	struct picture reference = {0};
	struct picture picture = {0};
	int status = 1;

	if (argc != 9) {
		fprintf(stderr,
			"usage: %s STEP FAR_PERCENT MEAN BLOCK_MEAN BLOCK_STRAYS"
			" REFERENCE PICTURE DIFFERENCE\n",
			argv[0]);
		return 2;
	}
	limit = (struct picture_tolerance){
		.step = atoi(argv[1]),
		.far_percent = atof(argv[2]),
		.mean = atof(argv[3]),
		.block_mean = atof(argv[4]),
		.block_strays = atoi(argv[5]),
	};
	if (picture_read(argv[6], &reference)) {
		printf("%s: cannot be read as a PNG\n", argv[6]);
	} else if (picture_read(argv[7], &picture)) {
		printf("%s: cannot be read as a PNG\n", argv[7]);
	} else {
		status = compare(&reference, &picture, &limit, argv[8]);
	}
	picture_release(&reference);
	picture_release(&picture);
	return status;
}
