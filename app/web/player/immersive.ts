// SPDX-License-Identifier: GPL-3.0-or-later
// The immersive view of a headset: the mesh stands in front of a person, a metre high or so, with a panel of controls
// below it. A trigger presses what its ray meets; a grip takes the mesh along.
import * as THREE from 'three';
import type { Playback } from './playback';
import type { Stage } from './stage';

const Height = 1.1;       // metres, of the mesh's middle
const Distance = 1.3;     // metres, in front of where the person stands
const Size = 0.9;         // metres, of the mesh's diagonal
const PanelWidth = 0.64;  // metres
const Pixels = { width: 640, height: 200 };
const Buttons = ['⏮', '−', '⏯', '+', '⏭', '✕'] as const;
const ScrubTop = 120; // pixels: above are the buttons
const RayLength = 3; // metres

export class Immersive {
    private readonly canvas = document.createElement('canvas');
    private readonly texture = new THREE.CanvasTexture(this.canvas);
    private readonly panel: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
    private readonly raycaster = new THREE.Raycaster();
    private readonly hands: THREE.XRTargetRaySpace[] = [];
    private scrubbing: THREE.XRTargetRaySpace | null = null;

    constructor(private readonly stage: Stage, private readonly playback: Playback, private readonly button: HTMLElement) {
        this.canvas.width = Pixels.width;
        this.canvas.height = Pixels.height;
        this.panel = new THREE.Mesh(
            new THREE.PlaneGeometry(PanelWidth, (PanelWidth * Pixels.height) / Pixels.width),
            new THREE.MeshBasicMaterial({ map: this.texture, transparent: true, side: THREE.DoubleSide }),
        );
        this.panel.position.set(0, Height - Size / 2 - 0.22, -Distance + 0.45);
        this.panel.rotation.x = -0.5;
        this.panel.visible = false;
        stage.scene.add(this.panel);
        void navigator.xr?.isSessionSupported('immersive-vr').then((isSupported) => (button.hidden = !isSupported)).catch(() => {});
        button.onclick = () => void this.enter();
        playback.addEventListener('change', () => {
            if (this.panel.visible) this.drawPanel();
        });
    }

    private async enter(): Promise<void> {
        const { renderer } = this.stage;
        const session = await navigator.xr!.requestSession('immersive-vr', { optionalFeatures: ['local-floor', 'hand-tracking'] }).catch(() => null);
        if (!session) return;
        session.addEventListener('end', () => this.leave());
        for (const index of [0, 1]) if (!this.hands[index]) this.addHand(index);
        renderer.xr.setReferenceSpaceType('local-floor');
        await renderer.xr.setSession(session);
        const scale = Size / Math.max(this.stage.diagonal, 1e-30);
        this.stage.holder.scale.setScalar(scale);
        this.stage.holder.position.copy(this.stage.middle).multiplyScalar(-scale).add(new THREE.Vector3(0, Height, -Distance));
        this.panel.visible = true;
        this.drawPanel();
    }

    private leave(): void {
        this.panel.visible = false;
        this.stage.scene.attach(this.stage.holder);
        this.stage.holder.position.set(0, 0, 0);
        this.stage.holder.quaternion.identity();
        this.stage.holder.scale.setScalar(1);
        for (const hand of this.hands) hand.visible = false;
        this.stage.invalidate();
        this.button.focus();
    }

    private addHand(index: number): void {
        const hand = this.stage.renderer.xr.getController(index);
        const ray = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3(0, 0, -RayLength)]);
        hand.add(new THREE.Line(ray, new THREE.LineBasicMaterial({ color: 0xd9a452, transparent: true, opacity: 0.6 })));
        hand.addEventListener('connected', () => (hand.visible = true));
        hand.addEventListener('selectstart', () => this.press(hand));
        hand.addEventListener('selectend', () => (this.scrubbing = null));
        hand.addEventListener('move', () => this.scrubbing === hand && this.scrub(hand));
        hand.addEventListener('squeezestart', () => hand.attach(this.stage.holder));
        hand.addEventListener('squeezeend', () => this.stage.scene.attach(this.stage.holder));
        this.stage.scene.add(hand);
        this.hands[index] = hand;
    }

    /// Where its ray meets the panel, pixels from the upper left.
    private place(hand: THREE.XRTargetRaySpace): { x: number; y: number } | null {
        hand.updateMatrixWorld();
        this.raycaster.ray.origin.setFromMatrixPosition(hand.matrixWorld);
        this.raycaster.ray.direction.set(0, 0, -1).transformDirection(hand.matrixWorld);
        const uv = this.raycaster.intersectObject(this.panel)[0]?.uv;
        return uv ? { x: uv.x * Pixels.width, y: (1 - uv.y) * Pixels.height } : null;
    }

    private press(hand: THREE.XRTargetRaySpace): void {
        const at = this.place(hand);
        if (!at) return this.playback.toggle();
        if (at.y > ScrubTop) {
            this.scrubbing = hand;
            this.playback.pause();
            return this.scrub(hand);
        }
        const { playback } = this;
        const actions = [
            () => playback.step(-1), () => playback.setRate(playback.rate - 5), () => playback.toggle(),
            () => playback.setRate(playback.rate + 5), () => playback.step(1), () => void this.stage.renderer.xr.getSession()?.end(),
        ];
        actions[Math.min(Math.floor((at.x / Pixels.width) * Buttons.length), Buttons.length - 1)]();
    }

    private scrub(hand: THREE.XRTargetRaySpace): void {
        const at = this.place(hand);
        if (at) this.playback.seek((at.x / Pixels.width) * (this.playback.frameCount - 1));
    }

    private drawPanel(): void {
        const context = this.canvas.getContext('2d')!;
        const { width, height } = Pixels;
        context.clearRect(0, 0, width, height);
        context.fillStyle = 'rgba(28, 31, 35, 0.92)';
        context.roundRect(0, 0, width, height, 24);
        context.fill();
        context.fillStyle = '#e4e2de';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        context.font = '44px sans-serif';
        Buttons.forEach((sign, i) => context.fillText(sign, ((i + 0.5) * width) / Buttons.length, 60));
        context.fillStyle = '#3c4148';
        context.fillRect(20, 136, width - 40, 12);
        context.fillStyle = '#d9a452';
        context.fillRect(20, 136, ((width - 40) * this.playback.frame) / Math.max(this.playback.frameCount - 1, 1), 12);
        context.fillStyle = '#e4e2de';
        context.font = '24px sans-serif';
        context.fillText(`${this.playback.frame + 1} / ${this.playback.frameCount}   ·   ${Math.round(this.playback.rate)} fps`, width / 2, 174);
        this.texture.needsUpdate = true;
    }
}
