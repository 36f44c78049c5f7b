// NumPy arrays that share the memory of Dipwright's values. Private to this folder.
#pragma once

#include <pybind11/numpy.h>

#include <QImage>
#include <memory>
#include <vector>

namespace dipwright::python {

namespace py = pybind11;

using Owner = std::shared_ptr<const void>;
using Shape = std::vector<py::ssize_t>;

// Makes an array unwritable, because others share its memory.
py::array readOnly(py::array array);
py::capsule capsuleOf(Owner owner);

// Returns a read-only array of the memory at `data`, row by row. The array keeps `owner` alive, and
// so the memory.
template <typename Value>
py::array sharedArray(Owner owner, const Value* data, Shape shape) {
    return readOnly(py::array_t<Value>(std::move(shape), data, capsuleOf(std::move(owner))));
}

// Returns a read-only array that takes over the values, one row for each `columns` of them.
template <typename Value>
py::array ownedArray(std::vector<Value> values, py::ssize_t columns = 1) {
    const auto owner = std::make_shared<const std::vector<Value>>(std::move(values));
    const auto rows = py::ssize_t(owner->size()) / columns;
    return sharedArray(owner, owner->data(), columns == 1 ? Shape{rows} : Shape{rows, columns});
}

// Returns the pixels: (height, width) of grey, or (height, width, 3 or 4) of colours, in 8 or 16
// bits. Shares the picture's memory unless its format has no such array.
py::array pixels(const QImage& picture);

} // namespace dipwright::python
