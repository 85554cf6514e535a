#pragma once

/// What is built in: everything, unless -DRAYPRO_WITHOUT_LENS and the like leave a feature out. Such a program is for
/// measuring only (script/price_of_features.sh): it is compared with the whole one on scenes without the feature, and
/// takes any scene for one of these.
namespace ray::features {

#ifdef RAYPRO_WITHOUT_LENS
inline constexpr bool lens = false;
#else
inline constexpr bool lens = true;              // a lens instead of a pinhole
#endif

#ifdef RAYPRO_WITHOUT_MOTION
inline constexpr bool motion = false;
#else
inline constexpr bool motion = true;            // a shutter that stays open while something moves
#endif

#ifdef RAYPRO_WITHOUT_ENVIRONMENT
inline constexpr bool environment = false;
#else
inline constexpr bool environment = true;       // light from all around
#endif

#ifdef RAYPRO_WITHOUT_TEXTURES
inline constexpr bool textures = false;
#else
inline constexpr bool textures = true;          // pictures on surfaces
#endif

#ifdef RAYPRO_WITHOUT_BUMP
inline constexpr bool bump = false;
#else
inline constexpr bool bump = true;              // reliefs on surfaces
#endif

#ifdef RAYPRO_WITHOUT_ABSORPTION
inline constexpr bool absorption = false;
#else
inline constexpr bool absorption = true;        // light lost inside of clear things
#endif

#ifdef RAYPRO_WITHOUT_FRESNEL
inline constexpr bool fresnel = false;
#else
inline constexpr bool fresnel = true;           // -fresnel
#endif

#ifdef RAYPRO_WITHOUT_GLOSSY
inline constexpr bool glossy = false;
#else
inline constexpr bool glossy = true;            // -glossy, of mode whitted
#endif

#ifdef RAYPRO_WITHOUT_ROULETTE
inline constexpr bool roulette = false;
#else
inline constexpr bool roulette = true;          // -roulette on, of mode whitted
#endif

#ifdef RAYPRO_WITHOUT_CHOICE_OF_LIGHTS
inline constexpr bool choice_of_lights = false;
#else
inline constexpr bool choice_of_lights = true;  // -lights one or a number, of mode whitted
#endif

}  // namespace ray::features
