#include "app/anim/fade.h"

#include "app/anim/pose_blend.h"

int fade_init(struct fade *fade, const struct model *model, struct arena *arena)
{
	*fade = (struct fade){.running = false};
	return pose_init(&fade->from, model, arena);
}

void fade_begin(struct fade *fade, const struct pose *shown, float duration_s,
	enum ease ease)
{
	pose_copy(&fade->from, shown);
	fade->ease = ease;
	fade->duration_s = duration_s;
	fade->elapsed_s = 0;
	fade->running = true;
}

bool fade_update(struct fade *fade, float step_s, struct pose *pose)
{
	float u;

	if (!fade->running) {
		return false;
	}
	fade->elapsed_s += step_s;
	if (!(fade->elapsed_s < fade->duration_s)) {
		fade->running = false;
		return false;
	}
	u = fade->elapsed_s / fade->duration_s;
	pose_mix(&fade->from, pose, ease_at(fade->ease, u), NULL, pose);
	return true;
}
