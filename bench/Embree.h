#pragma once

#include <dlfcn.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "R3/Mesh.h"

/// Embree beside us, found at run time: $EMBREE names the library, otherwise libembree4.so.4, then libembree3.so.3. The
/// few functions and constants used are declared here from its public interface, so that nothing depends on it.
namespace embree {

/// A ray and what it hit, as the library lays it out (the hit of version 4 is one number longer).
struct alignas(16) RayHit {
  float origin[3], near, direction[3], time, far;
  std::uint32_t mask, id, flags;
  float normal[3], u, v;
  std::uint32_t primitive, geometry, instance, instance_primitive;
};
inline constexpr std::uint32_t nothing = ~0u;

/// RayHit for `size` rays side by side, 8 or 16.
template <int size>
struct alignas(64) RayHits {
  float origin_x[size], origin_y[size], origin_z[size], near[size], direction_x[size], direction_y[size],
      direction_z[size], time[size], far[size];
  std::uint32_t mask[size], id[size], flags[size];
  float normal_x[size], normal_y[size], normal_z[size], u[size], v[size];
  std::uint32_t primitive[size], geometry[size], instance[size], instance_primitive[size];
};

enum Quality { low = 0, medium = 1, high = 2 };

class Library {
 public:
  /// Null when there is none.
  static std::unique_ptr<Library> Find() {
    auto library = std::make_unique<Library>();
    for (const char* name : {static_cast<const char*>(std::getenv("EMBREE")), "libembree4.so.4", "libembree3.so.3"})
      if (name && !library->handle_) library->handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (!library->handle_) return nullptr;
    const char* config = std::getenv("EMBREE_CONFIG");
    library->device = library->Call<void*(const char*)>("rtcNewDevice")(config ? config : "");
    const auto version =
        library->Call<long(void*, int)>("rtcGetDeviceProperty")(library->device, 0 /* RTC_DEVICE_PROPERTY_VERSION */);
    library->major = static_cast<int>(version / 10000);
    library->name = "Embree " + std::to_string(version / 10000) + "." + std::to_string(version / 100 % 100) + "." +
                    std::to_string(version % 100);
    return library;
  }

  template <typename Signature>
  Signature* Call(const char* function) const {
    void* found = dlsym(handle_, function);
    if (!found) std::abort();
    Signature* result;
    std::memcpy(&result, &found, sizeof result);
    return result;
  }

  void* device = nullptr;
  int major = 0;
  std::string name;

 private:
  void* handle_ = nullptr;
};

/// One mesh in a scene of its own.
class Scene {
 public:
  Scene(const Library& library, const R3::MeshData& mesh, Quality quality, bool robust) : library_(library) {
    const auto& call = library;
    void* geometry = call.Call<void*(void*, int)>("rtcNewGeometry")(library.device, 0 /* triangles */);
    const auto buffer =
        call.Call<void*(void*, int, unsigned, int, std::size_t, std::size_t)>("rtcSetNewGeometryBuffer");
    auto* corners = static_cast<float*>(buffer(geometry, 1, 0, 0x9003, 12, mesh.positions.size()));
    for (const R3::Point& p : mesh.positions)
      for (const double x : {p.x, p.y, p.z}) *corners++ = static_cast<float>(x);
    auto* indices = static_cast<std::uint32_t*>(buffer(geometry, 0, 0, 0x5003, 12, mesh.triangles.size()));
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * 12);
    call.Call<void(void*, int)>("rtcSetGeometryBuildQuality")(geometry, quality);
    call.Call<void(void*)>("rtcCommitGeometry")(geometry);
    scene_ = call.Call<void*(void*)>("rtcNewScene")(library.device);
    call.Call<void(void*, int)>("rtcSetSceneBuildQuality")(scene_, quality);
    if (robust) call.Call<void(void*, int)>("rtcSetSceneFlags")(scene_, 4);
    call.Call<unsigned(void*, void*)>("rtcAttachGeometry")(scene_, geometry);
    call.Call<void(void*)>("rtcReleaseGeometry")(geometry);
    intersect_ = call.Call<void(void*, void*, void*)>("rtcIntersect1");
    occluded_ = call.Call<void(void*, void*, void*)>("rtcOccluded1");
    intersect_8_ = call.Call<PacketQuery>("rtcIntersect8"), occluded_8_ = call.Call<PacketQuery>("rtcOccluded8");
    intersect_16_ = call.Call<PacketQuery>("rtcIntersect16"), occluded_16_ = call.Call<PacketQuery>("rtcOccluded16");
    Commit();
  }
  Scene(const Scene&) = delete;
  ~Scene() { library_.Call<void(void*)>("rtcReleaseScene")(scene_); }

  void Commit() { library_.Call<void(void*)>("rtcCommitScene")(scene_); }

  /// True on a hit.
  bool Intersect(RayHit& ray) const {
    ray.geometry = nothing;
    if (library_.major >= 4) {
      intersect_(scene_, &ray, nullptr);
    } else {
      Context context;
      intersect_(scene_, &context, &ray);
    }
    return ray.geometry != nothing;
  }
  bool IsOccluded(RayHit& ray) const {
    if (library_.major >= 4) {
      occluded_(scene_, &ray, nullptr);
    } else {
      Context context;
      occluded_(scene_, &context, &ray);
    }
    return ray.far < 0;
  }

  /// Rays are said to be coherent.
  template <int size>
  void Intersect(RayHits<size>& rays, const int* valid) const {
    std::fill_n(rays.geometry, size, nothing);
    Ask(size == 8 ? intersect_8_ : intersect_16_, &rays, valid);
  }
  template <int size>
  void IsOccluded(RayHits<size>& rays, const int* valid) const {
    Ask(size == 8 ? occluded_8_ : occluded_16_, &rays, valid);
  }

 private:
  using PacketQuery = void(const int*, void*, void*, void*);

  void Ask(PacketQuery* ask, void* rays, const int* valid) const {
    if (library_.major >= 4) {
      struct {
        std::uint32_t flags = 1u << 16;  // coherent
        std::uint32_t features = ~0u;
        void *context = nullptr, *filter = nullptr, *intersect = nullptr;
      } arguments;
      ask(valid, scene_, rays, &arguments);
    } else {
      Context context{1};  // coherent
      ask(valid, scene_, &context, rays);
    }
  }

  struct Context {
    std::uint32_t flags = 0;  // incoherent
    void* filter = nullptr;
    std::uint32_t instance = nothing;
    float min_width = 0;
  };

  const Library& library_;
  void* scene_ = nullptr;
  void (*intersect_)(void*, void*, void*) = nullptr;
  void (*occluded_)(void*, void*, void*) = nullptr;
  PacketQuery *intersect_8_ = nullptr, *occluded_8_ = nullptr, *intersect_16_ = nullptr, *occluded_16_ = nullptr;
};

}  // namespace embree
