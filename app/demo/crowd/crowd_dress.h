/*
 * The colours of a crowd's clothes.
 */
#ifndef APP_DEMO_CROWD_CROWD_DRESS_H
#define APP_DEMO_CROWD_CROWD_DRESS_H

#include "app/scene/instance/instance.h"

/*
 * Tints the textured parts of an instance, its clothes, in the colour of walker
 * number 0, 1 and so on. Twelve colours repeat. 0 or -ENOMEM.
 */
int crowd_dress(struct instance *instance, int number);

#endif
