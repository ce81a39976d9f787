// A program with two plug-ins, each with a weft of its own, all symbols thrown together.
#include <dlfcn.h>

#include <cstdio>

int main(int count, char** paths) {
  for (int i = 1; i < count; ++i) {
    void* plugin = dlopen(paths[i], RTLD_NOW | RTLD_GLOBAL);
    if (!plugin) {
      std::fprintf(stderr, "%s\n", dlerror());
      return 1;
    }
    void* symbol = dlsym(plugin, "run_consumer");
    if (!symbol || reinterpret_cast<int (*)()>(symbol)() != 0) return 1;
  }
}
