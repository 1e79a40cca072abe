#include "io/gltf_accessor.h"
#include "base/error.h"
#include <algorithm>
#include <cstring>
#include <limits>

namespace nacre::io {

namespace {

// A run of elements in a buffer, all of it known to be there.
struct View {
    const unsigned char *data = nullptr;
    std::size_t stride = 0;
};

template <typename T> double load(const unsigned char *bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if (!normalized || !std::numeric_limits<T>::is_integer) return static_cast<double>(value);
    // glTF 2.0, section 3.6.2.2: signed integers clamp at -1.
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double load(const unsigned char *bytes, int type, bool normalized) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return load<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return load<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return load<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return load<std::uint32_t>(bytes, normalized);
    default: return load<float>(bytes, false);
    }
}

class AccessorReader {
  public:
    AccessorReader(const GltfFile &file, int index, int width)
        : model(file.model), where(fmt::format("{}: accessors.{}", file.subject, index)), width(width) {
        if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
            input_error(where, "there are only {} accessors", model.accessors.size());
        accessor = &model.accessors[index];
    }

    std::vector<double> read() const {
        const int type = accessor->componentType;
        if (tinygltf::GetNumComponentsInType(accessor->type) != width)
            input_error(where, "has {} numbers per element, {} are expected",
                        tinygltf::GetNumComponentsInType(accessor->type), width);
        const std::size_t count = accessor->count, size = component_size(type);
        constexpr std::size_t most = 1u << 24; // of what is in no buffer, so that a false count allocates no terabytes
        if (accessor->bufferView < 0 && count > most) input_error(where, "{} elements without a buffer view", count);

        std::vector<double> values;
        if (accessor->bufferView < 0) {
            values.assign(count * width, 0.0);
        } else {
            const View elements = view(accessor->bufferView, accessor->byteOffset, count, size * width, true);
            values.resize(count * width); // after view() has found `count` to be true
            for (std::size_t i = 0; i < count; ++i) load_element(elements, i, size, type, &values[i * width]);
        }
        if (accessor->sparse.isSparse) replace_sparse(values, size);
        return values;
    }

  private:
    std::size_t component_size(int type) const {
        const int size = tinygltf::GetComponentSizeInBytes(type);
        if (size <= 0 || type == TINYGLTF_COMPONENT_TYPE_INT || type == TINYGLTF_COMPONENT_TYPE_DOUBLE)
            input_error(where, "has components of type {}, which glTF does not allow", type);
        return size;
    }

    // `count` elements of `size` bytes from `offset` on in buffer view `index`.
    View view(int index, std::size_t offset, std::size_t count, std::size_t size, bool strided) const {
        if (index < 0 || static_cast<std::size_t>(index) >= model.bufferViews.size())
            input_error(where, "names buffer view {}, there are {}", index, model.bufferViews.size());
        const tinygltf::BufferView &range = model.bufferViews[index];
        if (range.buffer < 0 || static_cast<std::size_t>(range.buffer) >= model.buffers.size())
            input_error(where, "buffer view {} names buffer {}, there are {}", index, range.buffer,
                        model.buffers.size());
        const std::vector<unsigned char> &bytes = model.buffers[range.buffer].data;
        if (range.byteOffset > bytes.size() || range.byteLength > bytes.size() - range.byteOffset)
            input_error(where, "buffer view {} goes beyond its buffer of {} bytes", index, bytes.size());
        const std::size_t stride = strided && range.byteStride ? range.byteStride : size;
        // The last element has no padding. Division, since the product may overflow.
        const bool fits =
            offset <= range.byteLength && (count == 0 || (size <= range.byteLength - offset &&
                                                          count - 1 <= (range.byteLength - offset - size) / stride));
        if (!fits) input_error(where, "{} elements go beyond buffer view {}", count, index);
        return {bytes.data() + range.byteOffset + offset, stride};
    }

    void load_element(const View &elements, std::size_t i, std::size_t size, int type, double *values) const {
        for (int component = 0; component < width; ++component)
            values[component] =
                load(elements.data + i * elements.stride + component * size, type, accessor->normalized);
    }

    // glTF 2.0, section 3.6.2.3: some elements are given apart, by index.
    void replace_sparse(std::vector<double> &values, std::size_t size) const {
        const auto &sparse = accessor->sparse;
        if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
            input_error(where, "its sparse part has a negative count or offset");
        const std::size_t count = sparse.count, index_size = component_size(sparse.indices.componentType);
        const View indices = view(sparse.indices.bufferView, sparse.indices.byteOffset, count, index_size, false);
        const View elements = view(sparse.values.bufferView, sparse.values.byteOffset, count, size * width, false);
        for (std::size_t i = 0; i < count; ++i) {
            const double target = load(indices.data + i * indices.stride, sparse.indices.componentType, false);
            if (!(target >= 0) || target >= static_cast<double>(accessor->count))
                input_error(where, "its sparse part names element {} of {}", target, accessor->count);
            load_element(elements, i, size, accessor->componentType, &values[static_cast<std::size_t>(target) * width]);
        }
    }

    const tinygltf::Model &model;
    const std::string where;
    const int width;
    const tinygltf::Accessor *accessor = nullptr;
};

} // namespace

std::vector<double> read_accessor(const GltfFile &file, int index, int width) {
    return AccessorReader(file, index, width).read();
}

} // namespace nacre::io
