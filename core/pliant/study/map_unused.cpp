#include <pliant/study/stability_map.h>

namespace pliant {

std::vector<UnusedSetting> unused_settings(const MapOrder& order) {
    UsedSettings settings(*order.lesson);
    settings.set(order.settings);
    const auto lesson = order.lesson->make();
    const auto value = [&](const Knob& knob, std::size_t number) {
        return std::pair(knob.key, lesson->parameter(knob.key).text(knob.values[number]));
    };
    for (std::size_t j = 0; j < order.up.values.size(); ++j)
        for (std::size_t i = 0; i < order.across.values.size(); ++i) {
            settings.set({value(order.across, i), value(order.up, j)});
            settings.look();
        }
    return settings.unused();
}

}  // namespace pliant
