#include "source/film/denoise/Denoiser.h"

#include "source/film/denoise/OpenImageDenoise.h"

namespace ray {

Denoiser Resolved(Denoiser denoiser) {
  if (denoiser != Denoiser::automatic) return denoiser;
  return OpenImageDenoise::IsPresent() ? Denoiser::both : Denoiser::regression;
}

}  // namespace ray
