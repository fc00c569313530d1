// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/analysis/parts.h"

#include <numeric>

namespace model {

namespace {

constexpr std::uint32_t NoSheet = ~std::uint32_t(0);

/// Faces joined over edges of two sides.
struct Sheets
{
    std::vector<std::uint32_t> of; ///< #F
    std::vector<std::uint8_t> isOrientable;
};

Sheets findSheets(const FaceLinks &links, std::vector<std::uint8_t> &isTurned)
{
    const Faces &faces = links.faces();
    Sheets sheets{std::vector<std::uint32_t>(faces.faceCount(), NoSheet), {}};
    std::vector<std::uint32_t> sheet; // its faces, in the order in which they are reached
    for (std::uint32_t start = 0; start < faces.faceCount(); ++start) {
        if (sheets.of[start] != NoSheet)
            continue;
        const std::uint32_t number = std::uint32_t(sheets.isOrientable.size());
        sheets.of[start] = number;
        sheet.assign(1, start);
        bool isOrientable = true;
        std::size_t turned = 0;
        for (std::size_t at = 0; at < sheet.size(); ++at) {
            const std::uint32_t face = sheet[at];
            for (std::uint32_t side = faces.begin(face); side < faces.end(face); ++side) {
                if (!links.isLinked(side))
                    continue;
                const std::uint32_t neighbour = faces.faceOf(links.across(side));
                const std::uint8_t turn = isTurned[face] ^ std::uint8_t(links.isTwisted(side));
                if (sheets.of[neighbour] == NoSheet) {
                    sheets.of[neighbour] = number;
                    isTurned[neighbour] = turn;
                    turned += turn;
                    sheet.push_back(neighbour);
                } else if (isTurned[neighbour] != turn) {
                    isOrientable = false;
                }
            }
        }
        if (isOrientable && 2 * turned > sheet.size())
            for (const std::uint32_t face : sheet)
                isTurned[face] ^= 1;
        sheets.isOrientable.push_back(isOrientable);
    }
    return sheets;
}

} // namespace

MeshParts findParts(const FaceLinks &links)
{
    const Faces &faces = links.faces();
    MeshParts parts;
    parts.isTurned.resize(faces.faceCount());
    Sheets sheets = findSheets(links, parts.isTurned);

    // Crowded edges join sheets.
    std::vector<std::uint32_t> root(sheets.isOrientable.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto rootOf = [&](std::uint32_t sheet) {
        while (root[sheet] != sheet)
            sheet = root[sheet] = root[root[sheet]];
        return sheet;
    };
    for (const FaceLinks::CrowdedEdge &edge : links.crowded())
        for (const std::uint32_t side : edge.sides) {
            const std::uint32_t a = rootOf(sheets.of[faces.faceOf(edge.sides[0])]);
            const std::uint32_t b = rootOf(sheets.of[faces.faceOf(side)]);
            root[std::max(a, b)] = std::min(a, b);
        }
    // Sheets, and so the smallest of each component, are in the order of their first faces.
    std::vector<std::uint32_t> component(root.size());
    for (std::uint32_t sheet = 0; sheet < root.size(); ++sheet) {
        const std::uint32_t first = rootOf(sheet);
        if (first == sheet) {
            component[sheet] = parts.componentCount();
            parts.isOrientable.push_back(sheets.isOrientable[sheet]);
        } else {
            component[sheet] = component[first];
            parts.isOrientable[component[first]] &= sheets.isOrientable[sheet];
        }
    }
    parts.componentOf = std::move(sheets.of);
    for (std::uint32_t &of : parts.componentOf)
        of = component[of];
    return parts;
}

} // namespace model
