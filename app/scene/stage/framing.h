/*
 * How figures and labels share a picture.
 */
#ifndef APP_SCENE_STAGE_FRAMING_H
#define APP_SCENE_STAGE_FRAMING_H

#include "app/scene/stage/camera.h"

/* Rows of the groups in the corner below the labels. */
struct framing_below {
	int keys;     /* of a list of keys, which is a wide group */
	int switches; /* of what buttons do now, and of live pictures */
};

/* How figures are framed, and what their labels take of the picture. */
struct framing {
	struct camera_framing camera;
	/*
	 * Rows of the labels in the top left corner besides their title, and
	 * how many of these rows have bars.
	 */
	int label_rows, label_bars; /* 0: there are no labels */
	bool labels_right;          /* the labels are in the top right corner */
	int lines_below;            /* lines of text along the lower edge */
	bool frame_times;           /* their graph is shown */
	struct framing_below below;
};

/*
 * Returns a part of a picture of this size that labels, the group below and the
 * graph of frame times leave free: of the parts beside, below or above them the
 * one in which the box appears largest. A small picture has room for less of
 * the graph: first the stages' times give way, then the bars
 * (hud_graph_show()), and at last figures stand behind the labels.
 */
struct camera_region framing_region(const struct framing *framing,
	const struct bounds *bounds, int width, int height);

#endif
