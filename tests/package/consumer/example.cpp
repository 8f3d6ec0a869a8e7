#include <frostfill/renderer.hpp>
#include <frostfill/simulation.hpp>

int main()
{
    using namespace frostfill;
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.count = 100;

    const LoadedMesh loaded = loadMesh(scene.object.mesh);
    Simulation simulation(scene, loaded.mesh);
    while (simulation.step())
    {
    }

    Snapshot snapshot;
    simulation.capture(snapshot);
    Renderer renderer(loaded.mesh, RenderSettings{});
    Image image;
    renderer.render(snapshot, image);
    savePng(image, "torus.png");
}
