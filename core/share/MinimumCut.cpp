#include "share/MinimumCut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>

namespace dipwright {
namespace {

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;

struct Node {
    boost::default_color_type colour = boost::white_color;
    Traits::edge_descriptor predecessor;
    long distance = 0;
};
struct Arc {
    std::int64_t capacity = 0, residual = 0;
    Traits::edge_descriptor reverse;
};
using Network = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Node, Arc>;

// Converts a cost to an integer. Sums of integers are exact, so the flow search terminates.
std::int64_t whole(double cost) {
    return std::int64_t(std::min(std::max(cost, 0.0), 1e9) * 1e4);
}

void connect(Network& network, std::size_t from, std::size_t to, std::int64_t there,
             std::int64_t back) {
    const auto arc = boost::add_edge(from, to, Arc{there, 0, {}}, network).first;
    const auto reverse = boost::add_edge(to, from, Arc{back, 0, {}}, network).first;
    network[arc].reverse = reverse;
    network[reverse].reverse = arc;
}

} // namespace

std::vector<std::uint8_t> minimumCut(const std::vector<std::array<double, 2>>& costs,
                                     const std::vector<CutEdge>& edges) {
    const std::size_t items = costs.size();
    const std::size_t source = items; // stands for label 0
    const std::size_t sink = items + 1;
    Network network(items + 2);
    for (std::size_t item = 0; item < items; ++item) {
        connect(network, source, item, whole(costs[item][1]), 0);
        connect(network, item, sink, whole(costs[item][0]), 0);
    }
    for (const CutEdge& edge : edges) {
        connect(network, edge.from, edge.to, whole(edge.cost), whole(edge.cost));
    }
    boost::boykov_kolmogorov_max_flow(
        network, boost::get(&Arc::capacity, network), boost::get(&Arc::residual, network),
        boost::get(&Arc::reverse, network), boost::get(&Node::predecessor, network),
        boost::get(&Node::colour, network), boost::get(&Node::distance, network),
        boost::get(boost::vertex_index, network), source, sink);
    std::vector<std::uint8_t> labels(items);
    for (std::size_t item = 0; item < items; ++item) {
        labels[item] = network[item].colour == boost::black_color ? 0 : 1;
    }
    return labels;
}

} // namespace dipwright
