// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tin/tin.h"
#include "model/terrain/tin/tinwriter.h"

#include <limits>

namespace model::terrain {

/// What becomes of the volume that changes because the surface is triangulated anew, not because somebody raised or
/// lowered it.
enum class VolumeRule : std::uint8_t {
    GiveBack, ///< it is spread over the vertices that were created or connected anew
    Keep,     ///< heights stay as they are, and the ledger says what that changed
};

/// What constrain() does where the line crosses a constrained edge.
enum class Crossing : std::uint8_t {
    Refuse,  ///< nothing at all is done
    Release, ///< that edge loses its constraints
    Split,   ///< both get a vertex where they cross, at the height of the older one
};

/// An open change of a TIN: the only way to change one. Goes through the journal; commit() makes it an Edit, and what
/// is not committed is undone. The TIN is valid, and may be read and drawn, between any two calls.
class TinEdit
{
public:
    /// Precondition: no edit of `tin` is open.
    explicit TinEdit(Tin &tin, VolumeRule rule = VolumeRule::GiveBack);
    ~TinEdit();
    TinEdit(const TinEdit &) = delete;
    TinEdit &operator=(const TinEdit &) = delete;

    const Tin &tin() const { return mTin; }

    /// Puts a vertex on the surface at `p`, or finds the one there. A constrained edge through `p` stays constrained on
    /// both sides. Precondition: `p` lies in the domain; `near` is a vertex, or None.
    VertexId insert(Point2 p, VertexId near = None);
    /// The same at height `height`: a vertex found is moved there.
    VertexId insert(Point2 p, double height, VertexId near = None);

    /// False for vertices with constraints, and for the domain's corners.
    bool canRemove(VertexId v) const;
    /// Precondition: canRemove(v).
    void remove(VertexId v);
    /// Removes all vertices inside `ring`: edges that each are constrained, counter-clockwise. False if nothing was
    /// done because not all of them can go, there is a void or a constraint inside, or the ring touches itself.
    bool removeInside(std::span<const VertexId> ring);

    /// Makes the line from `a` to `b` a union of edges, through the vertices that lie on it, and constrains them for
    /// `owner`. \error CrossingConstraints  it crosses a constrained edge, and `crossing` is Refuse, or that edge
    /// bounds a void; nothing
    ///                             is changed. args: the vertices of the line, those of the edge
    /// Precondition: `a` and `b` are different vertices; `owner` is not None.
    Result<void> constrain(VertexId a, VertexId b, OwnerId owner, Crossing crossing = Crossing::Refuse);
    /// Takes the constraint of `owner` off the edge a-b, if there is one. The edge stays if the circle rule wants it.
    void release(VertexId a, VertexId b, OwnerId owner);
    /// Takes all constraints off the edge a-b, but not what bounds the domain or a void.
    void releaseAll(VertexId a, VertexId b);
    /// Takes all constraints of `owner` away. Cost: O(all constraints).
    void releaseOwner(OwnerId owner);

    /// Marks triangles as void or not. Edges between void and other triangles are constrained, for VoidOwner.
    void setVoid(std::span<const TriangleId> triangles, bool isVoid);

    /// Upwards the top layer grows; downwards it is dug from the top layer into the next and at last into the bedrock.
    /// The ledger counts it as added or removed.
    void setHeight(VertexId v, double height);
    /// Lowers `from` and raises `to` by what `volume` takes: each layer moves with its humidity, and bedrock becomes
    /// part of the top layer. The ledger counts it as moved.
    void transfer(VertexId from, VertexId to, double volume);

    /// Inserts an empty layer below the one that is `layer` now, or on top. `material` is an index into the terrain's
    /// list. Cost: O(n). Precondition: `layer` <= their number < MaxLayers.
    void addLayer(std::uint32_t layer, std::uint8_t material);
    /// What the layer held becomes bedrock; the surface stays. Cost: O(n).
    void removeLayer(std::uint32_t layer);
    void setLayerMaterial(std::uint32_t layer, std::uint8_t material);
    /// Says what a layer is at `v`. The surface stays where it is; the bedrock gives way.
    /// Precondition: thickness finite and at least 0, humidity 0 ... 1.
    void setLayer(VertexId v, std::uint32_t layer, LayerSample sample);
    /// Puts that much more onto a layer, and the surface up by it. The ledger counts it as added.
    void deposit(VertexId v, std::uint32_t layer, LayerSample sample);
    /// Presses the layers at `v` together from the top, by up to `depth`: they lose volume and keep their mass. The
    /// bedrock does not give way. Returns by how much the surface went down.
    double press(VertexId v, double depth);

    /// Puts the surface and the layers at `v` where transfers between vertices, worked out elsewhere, have brought
    /// them. They keep the volume, and bookMoved() says how much they moved: the ledger hears nothing of it here.
    /// \param thicknesses, humidities  a value for each layer; not read without layers
    void place(VertexId v, double height, const double *thicknesses, const float *humidities);
    /// The dual area of `v` as it is now. Cost: that of going around it.
    double areaOf(VertexId v) const { return dualArea(mArrays, v); }

    /// What the surface gained in volume, and has not given back.
    double leak() const { return mWriter.leak.value(); }
    /// Sets the height of `v`; the volume that takes is owed, as part of the leak.
    void displace(VertexId v, double height);
    /// Counts this part of the leak as added (above 0) or removed (below 0): it is no longer owed.
    void bookLeak(double volume);
    /// Counts a volume as moved that place(), or displace() and giveBack(), moved.
    void bookMoved(double volume);
    /// Counts `volume` of the leak (below 0 by at least that) as pressed together, in the top layer: lost as volume,
    /// kept as mass. Precondition: `volume` >= 0.
    void bookPressed(double volume);
    /// Spreads the leak over `vertices`: the height of each changes in proportion to its weight (empty: all alike).
    /// Nothing happens if their areas and weights add up to nothing.
    void giveBack(std::span<const VertexId> vertices, std::span<const double> weights = {});

    /// The same with `volume` instead of the leak, against which it counts: who knows which part of the leak is its own
    /// gives it back so. A weight of 1 goes no further up or down than `most`, and the rest stays owed.
    void giveBackVolume(std::span<const VertexId> vertices, double volume, std::span<const double> weights = {},
                        double most = std::numeric_limits<double>::infinity());

    /// Does with the leak what commit() does with it. A step of an edit that ends with this leaves the same bytes
    /// whether what follows belongs to the edit or to the next one.
    void settle();

    /// Ends the edit.
    Edit commit();
    /// Ends the edit as if it had not begun.
    void rollBack();
    /// It has not ended.
    bool isOpen() const { return mIsOpen; }

private:
    struct Segment
    {
        VertexId a, b;
        OwnerId owner;
    };

    void constrainEdge(Corner c, OwnerId owner);
    void unconstrain(Corner c);
    void split(Corner c, std::vector<Segment> &segments, const Segment &segment);
    bool isFreeOf(const Segment &segment, Crossing crossing, Corner &blocking) const;
    void lift(std::span<const VertexId> vertices, std::span<const double> weights, double volume, double most);
    Edit end();

    Tin &mTin;
    TinArrays &mArrays;
    const VolumeRule mRule;
    TinWriter mWriter;
    bool mIsOpen = true;
};

} // namespace model::terrain
