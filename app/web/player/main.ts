// SPDX-License-Identifier: GPL-3.0-or-later
// The page: joins list, worker, picture and controls.
import { Animation, loadDecoder, startWorker } from './animation';
import { Controls, element } from './controls';
import type { Header, NamedError } from './decoder';
import { TooLarge } from './gpuframes';
import { Immersive } from './immersive';
import { Playback } from './playback';
import { loadPlayList, markChosen, showPlayList, type ListItem } from './playlist';
import { Stage } from './stage';
import { errorText, text } from './texts';

class Player {
    readonly playback = new Playback();
    readonly stage: Stage;
    /// For benchmarks: when what was asked for has been seen.
    readonly times = { opened: 0, firstPicture: 0, decode: 0, frames: [] as number[] };
    readonly controls: Controls;
    private readonly list = element('list');
    private items: ListItem[] = [];
    private chosen = -1;
    private spare: Worker = startWorker(); // so that the next file need not wait for one
    private animation: Animation | null = null;
    private header: Header | null = null;
    private bands = '';
    private shownFrame = -1;
    private hasFrame = false;
    private askedForEdges = false;
    private isComplete = false;
    private error: NamedError | null = null;
    private lastTime = 0;

    constructor(private readonly decoder: WebAssembly.Module) {
        this.stage = new Stage(element<HTMLCanvasElement>('canvas'));
        this.controls = new Controls(this.playback, this.stage, {
            open: (file) => this.openFile(file),
            next: (by) => this.choose(this.chosen + by),
            styleChanged: () => this.edgesIfNeeded(),
            languageChanged: () => this.showTexts(),
        });
        const dark = matchMedia('(prefers-color-scheme: dark)');
        const setDark = () => this.stage.setDark(dark.matches);
        dark.addEventListener('change', setDark);
        setDark();
        new Immersive(this.stage, this.playback, element('xr'));
        element('message').querySelector('button')!.onclick = () => this.showError(null);
        this.acceptDrops();
        this.stage.renderer.setAnimationLoop((time) => this.tick(time));
        window.addEventListener('hashchange', () => this.chooseByAddress());
        this.playback.addEventListener('change', () => this.stage.invalidate());
    }

    async start(): Promise<void> {
        this.items = await loadPlayList().catch(() => []);
        document.body.classList.toggle('single', this.items.length === 1);
        showPlayList(this.list, this.items, (index) => this.choose(index));
        if (!this.chooseByAddress()) this.choose(0);
    }

    choose(index: number): void {
        const item = this.items[index];
        if (!item) return;
        this.chosen = index;
        markChosen(this.list, index);
        history.replaceState(null, '', `#${index + 1}`);
        this.open(new URL(item.file, document.baseURI).href, item.name);
    }

    openFile(file: File): void {
        this.chosen = -1;
        markChosen(this.list, -1);
        this.open(file, file.name.replace(/\.anim$/i, ''));
    }

    private chooseByAddress(): boolean {
        const index = Number(location.hash.slice(1)) - 1;
        if (!(index in this.items) || index === this.chosen) return index in this.items;
        this.choose(index);
        return true;
    }

    private open(source: string | Blob, name: string): void {
        this.animation?.close();
        this.showError(null);
        this.times.opened = performance.now();
        this.times.firstPicture = this.times.decode = 0;
        this.header = null;
        this.bands = '';
        this.shownFrame = -1;
        this.hasFrame = this.askedForEdges = this.isComplete = false;
        this.stage.clear();
        this.playback.pause();
        this.playback.reset(1, this.playback.rate);
        element('name').textContent = name;
        element('info').textContent = '';
        this.showProgress(0, 0, name);
        this.animation = new Animation(this.spare, this.decoder, source, {
            header: (header) => this.takeHeader(header),
            mesh: (mesh) => this.guarded(() => {
                this.stage.setMesh(mesh);
                this.hasFrame = this.askedForEdges = false;
            }),
            linear: ({ rows, first, layers }) => this.guarded(() => {
                this.stage.frames?.setLinear(rows, this.header!.frameCount, first, layers);
                this.hasFrame = true;
                this.shownFrame = -1;
                this.startPlaying();
            }),
            bounds: (bounds) => this.stage.setBounds(bounds),
            frame: (index, texels) => this.guarded(() => {
                this.stage.frames?.setTexels(texels);
                this.shownFrame = index;
                this.hasFrame = true;
                this.stage.invalidate();
                this.startPlaying();
            }),
            edges: (edges) => this.stage.setEdges(edges),
            progress: ({ bytes, total, bands, bandsInFile }) => {
                this.bands = bandsInFile > bands ? text('quality', bands, bandsInFile) : '';
                this.showProgress(bytes, total, name);
                this.showInfo();
            },
            complete: (_, milliseconds) => {
                this.isComplete = true;
                this.times.decode = milliseconds;
                element('progress').hidden = true;
                this.edgesIfNeeded();
                document.body.dataset.state = 'complete';
            },
            error: (error) => this.showError(error),
        });
        this.stage.warmUp();
        this.spare = startWorker();
        document.body.dataset.state = 'loading';
    }

    private takeHeader(header: Header): void {
        this.header = header;
        if (header.name) element('name').textContent = header.name;
        this.playback.reset(header.frameCount, header.frameRate);
        this.showInfo();
    }

    /// As soon as there is something to see, unless this person would rather have things stand still.
    private startPlaying(): void {
        if (this.times.firstPicture || this.playback.isPlaying || this.playback.frame !== 0) return;
        if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.playback.play();
    }

    private guarded(action: () => void): void {
        try {
            action();
        } catch (error) {
            if (!(error instanceof TooLarge)) throw error;
            this.showError({ name: 'TooLargeForGpu', args: [], offset: -1 });
        }
    }

    private edgesIfNeeded(): void {
        if (!this.isComplete || this.askedForEdges || !this.stage.needsEdges) return;
        this.askedForEdges = true;
        this.animation?.askForEdges();
    }

    private tick(time: number): void {
        const begin = performance.now();
        // Half a second without a picture, as in a tab behind others, is no time to catch up with.
        this.playback.advance(Math.min((time - this.lastTime) / 1000, 0.5));
        this.lastTime = time;
        const { frame } = this.playback;
        if (this.hasFrame && frame !== this.shownFrame && this.header) {
            if (this.header.isLinear) {
                this.stage.frames?.evaluate(frame);
                this.shownFrame = frame;
            } else {
                const texels = this.animation?.want(frame);
                if (texels) {
                    this.stage.frames?.setTexels(texels);
                    this.shownFrame = frame;
                }
            }
            this.stage.invalidate();
        }
        this.stage.draw();
        if (!this.hasFrame) return;
        if (!this.times.firstPicture && this.shownFrame >= 0) this.times.firstPicture = performance.now();
        if (this.playback.isPlaying && this.times.frames.length < 600) this.times.frames.push(performance.now() - begin);
    }

    private showTexts(): void {
        this.showInfo();
        this.showError(this.error);
    }

    private showInfo(): void {
        const { header } = this;
        if (!header) return;
        const info = text('info', header.vertexCount, header.triangleCount, header.frameCount);
        element('info').textContent = this.bands ? `${info} · ${this.bands}` : info;
    }

    private showProgress(bytes: number, total: number, name: string): void {
        const bar = element('progress');
        const share = total > 0 ? Math.min(100, Math.round((100 * bytes) / total)) : 0;
        bar.hidden = false;
        bar.setAttribute('aria-valuenow', String(share));
        bar.setAttribute('aria-label', text('loading', name));
        bar.querySelector('i')!.style.width = `${share}%`;
        bar.querySelector('span')!.textContent = text('loading', name) + (total > 0 ? ` · ${share} %` : '');
    }

    private showError(error: NamedError | null): void {
        this.error = error;
        const message = element('message');
        message.hidden = error === null;
        if (!error) return;
        message.dataset.error = error.name;
        message.querySelector('span')!.textContent = errorText(error);
        element('progress').hidden = true;
        document.body.dataset.state = 'error';
    }

    private acceptDrops(): void {
        const mark = element('drop');
        let depth = 0;
        const show = (by: number) => {
            depth = Math.max(0, depth + by);
            mark.hidden = depth === 0;
        };
        document.addEventListener('dragenter', () => show(1));
        document.addEventListener('dragleave', () => show(-1));
        document.addEventListener('dragover', (event) => event.preventDefault());
        document.addEventListener('drop', (event) => {
            event.preventDefault();
            show(-depth);
            const file = event.dataTransfer?.files[0];
            if (file) this.openFile(file);
        });
    }
}

function stopWith(message: string): void {
    const box = element('message');
    box.hidden = false;
    box.querySelector('button')!.hidden = true;
    box.querySelector('span')!.textContent = message;
}

if (!document.createElement('canvas').getContext('webgl2')) {
    stopWith(text('noWebGl'));
} else {
    try {
        const player = new Player(await loadDecoder());
        Object.assign(globalThis, { sandreelPlayer: player }); // tests, benchmarks, and pages that embed this one
        await player.start();
    } catch (error) {
        stopWith(text('cannotStart', String((error as Error).message)));
    }
}
