#include "sim/window.hpp"

#include <SDL.h>

#include "assetc/input_error.hpp"
#include "sim/engine.hpp"
#include "sim/orbit.hpp"
#include "sim/output_file.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

constexpr std::uint32_t kFrameMs = 33;  // motion runs at 30 frames a second

[[noreturn]] void fail_with_sdl() { throw InputError("view", std::string("no window: ") + SDL_GetError()); }

// SDL and one window with a texture of the picture's size.
class Window {
 public:
  Window(std::uint16_t width, std::uint16_t height) : width_(width) {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail_with_sdl();
    const int zoom = std::max(1, 960 / std::max<int>(width, height));
    window_ = SDL_CreateWindow("Spanline", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width * zoom, height * zoom,
                               SDL_WINDOW_RESIZABLE);
    if (window_ != nullptr) renderer_ = SDL_CreateRenderer(window_, -1, 0);
    if (renderer_ != nullptr) {
      SDL_RenderSetLogicalSize(renderer_, width, height);
      texture_ = SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING, width, height);
    }
    if (texture_ == nullptr) {
      const std::string why = SDL_GetError();
      close();
      throw InputError("view", "no window: " + why);
    }
  }
  ~Window() { close(); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void show(const Picture& picture) {
    SDL_UpdateTexture(texture_, nullptr, picture.rgb.data(), 3 * width_);
    SDL_RenderClear(renderer_);
    SDL_RenderCopy(renderer_, texture_, nullptr, nullptr);
    SDL_RenderPresent(renderer_);
  }
  void title(const std::string& text) { SDL_SetWindowTitle(window_, text.c_str()); }

 private:
  void close() {
    SDL_DestroyTexture(texture_);
    SDL_DestroyRenderer(renderer_);
    SDL_DestroyWindow(window_);
    SDL_Quit();
  }

  int width_;
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  SDL_Texture* texture_ = nullptr;
};

// What the user has asked for since the last picture.
struct Wishes {
  bool quit = false, save = false, toggle = false, changed = false;
};

Wishes read_events(Orbit& orbit, bool& walked) {
  constexpr double kDegreesPerPixel = 0.4;
  constexpr double kZoomStep = 0.9;
  Wishes wishes;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    if (event.type == SDL_QUIT) wishes.quit = true;
    if (event.type == SDL_WINDOWEVENT) wishes.changed = true;
    if (event.type == SDL_MOUSEMOTION && (event.motion.state & SDL_BUTTON_LMASK) != 0) {
      orbit.turn(-kDegreesPerPixel * event.motion.xrel, kDegreesPerPixel * event.motion.yrel);
      walked = wishes.changed = true;
    }
    if (event.type == SDL_MOUSEWHEEL) {
      orbit.zoom(std::pow(kZoomStep, event.wheel.y));
      walked = wishes.changed = true;
    }
    if (event.type != SDL_KEYDOWN) continue;
    if (event.key.keysym.sym == SDLK_ESCAPE) wishes.quit = true;
    if (event.key.keysym.sym == SDLK_SPACE) wishes.toggle = true;
    if (event.key.keysym.sym == SDLK_s) wishes.save = true;
  }
  return wishes;
}

void render(CompiledScene& scene, Engine& engine, Rendering& rendering) {
  const SceneRecord record = scene.record();
  const std::string& place = scene.description().place;
  const Status status = engine.render(validated(record, place), scene.camera(), rendering);
  if (!status.ok()) throw InputError(place, status_text(status));
}

// The first free name of spanline-0000.png …; .ppm where this build has no libpng.
std::string save(const Picture& picture) {
  const std::string pattern = png_available() ? "spanline.png" : "spanline.ppm";
  std::int64_t number = 0;
  while (file_exists(numbered_path(pattern, number, number))) ++number;
  std::string path = numbered_path(pattern, number, number);
  write_picture(path, picture);
  return path;
}

}  // namespace

void refuse_without_window() {}

void show_in_window(CompiledScene& scene, double reach) {
  EngineOptions options;
  options.width = scene.description().width;
  options.height = scene.description().height;
  const std::unique_ptr<Engine> engine = Engine::make(options);
  Window window(options.width, options.height);
  Orbit orbit(scene.view(), scene.bounds(), options.height, reach);
  Rendering rendering;
  std::int64_t frame = 0;
  bool running = scene.moves(), walked = false, stale = true;
  for (;;) {
    const Uint32 began = SDL_GetTicks();
    const Wishes wishes = read_events(orbit, walked);
    if (wishes.quit) return;
    if (wishes.toggle) running = !running && scene.moves();
    if (stale || wishes.changed || running) {
      scene.show(frame);
      if (walked) scene.look(orbit.view());  // from then on the viewer goes where the mouse says
      render(scene, *engine, rendering);
      window.show(rendering.picture);
      stale = false;
    }
    if (running) ++frame;
    if (wishes.save) window.title("Spanline: saved " + save(rendering.picture));
    const Uint32 spent = SDL_GetTicks() - began;
    if (spent < kFrameMs) SDL_Delay(kFrameMs - spent);
  }
}

}  // namespace spanline::host
