/*
 * Colours as a screen shows them.
 *
 * Fixed-function GL multiplies and adds colours as it gets them. Encoding each
 * factor before is exact for products but for the linear toe of the curve, as
 * (ab)^(1/g) = a^(1/g) b^(1/g), and leaves textures as they are.
 */
#ifndef APP_MODEL_COLOR_H
#define APP_MODEL_COLOR_H

/*
 * Linear 0..1 to sRGB 0..1 and back (IEC 61966-2-1); for load time. Values
 * beyond are clamped, NaN gives 0.
 */
float color_encode_srgb(float linear);
float color_decode_srgb(float encoded);

#endif
