// Shows the page's model: turns it by mouse, finger and keys, and switches its layers.
(function () {
    'use strict';

    const root = document.documentElement;
    const canvas = document.querySelector('canvas');
    const stage = document.querySelector('.stage');
    const radios = Array.from(document.querySelectorAll('.layers input'));
    const layers = JSON.parse(document.getElementById('layers').textContent);

    function fail(error) {
        root.classList.add('failed');
        root.dataset.state = 'failed';
        document.querySelector('.wait').textContent = '';
        console.error(error);
    }

    function bytesOf(id) {
        const element = document.getElementById(id);
        const text = atob(element.textContent.trim());
        const bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; ++i) {
            bytes[i] = text.charCodeAt(i);
        }
        element.remove(); // the text is large and needed once
        return bytes.buffer;
    }

    // The directions from the middle of the part to the camera.
    const directions = {
        oblique: [0.5, 0.45, 0.8],
        front: [0, 0, 1],
        right: [1, 0, 0],
        back: [0, 0, -1],
        left: [-1, 0, 0],
        above: [0, 1, 0.001],
        below: [0, -1, 0.001],
    };

    // Returns the corners of all triangles, in metres.
    function cornersOf(scene) {
        const corners = [];
        scene.updateMatrixWorld(true);
        scene.traverse((node) => {
            if (node.isMesh) {
                const positions = node.geometry.attributes.position;
                for (let i = 0; i < positions.count; ++i) {
                    corners.push(new THREE.Vector3().fromBufferAttribute(positions, i)
                        .applyMatrix4(node.matrixWorld));
                }
            }
        });
        return corners;
    }

    function Viewer(scene) {
        const renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
        renderer.setClearAlpha(0);
        renderer.gammaOutput = true;
        renderer.gammaFactor = 2.2;
        const camera = new THREE.PerspectiveCamera(30, 1, 0.001, 10);
        const world = new THREE.Scene();
        world.add(scene);
        world.add(new THREE.HemisphereLight(0xffffff, 0xb8b8b8, 0.72));
        const lamp = new THREE.DirectionalLight(0xffffff, 0.42);
        lamp.position.set(-0.5, 0.6, 1); // over the viewer's left shoulder
        camera.add(lamp);
        camera.add(lamp.target);
        world.add(camera);
        const sphere = new THREE.Box3().setFromObject(scene).getBoundingSphere(new THREE.Sphere());

        const controls = new THREE.OrbitControls(camera, canvas);
        controls.enableKeys = false;
        controls.target.copy(sphere.center);
        controls.minDistance = 0.3 * sphere.radius;
        controls.maxDistance = 100 * sphere.radius;

        let isWaiting = false;
        function draw() {
            if (!isWaiting) {
                isWaiting = true;
                requestAnimationFrame(() => {
                    isWaiting = false;
                    renderer.render(world, camera);
                });
            }
        }

        const corners = cornersOf(scene);

        // Returns the distance from which the whole part is seen along a direction.
        function fittingDistance(direction) {
            const back = direction.clone().normalize();
            const right = new THREE.Vector3(0, 1, 0).cross(back).normalize();
            const up = back.clone().cross(right);
            const tangent = Math.tan(THREE.Math.degToRad(camera.fov / 2));
            let most = 0;
            for (const corner of corners) {
                const place = corner.clone().sub(sphere.center);
                const aside = Math.abs(place.dot(right)) / (tangent * camera.aspect);
                const above = Math.abs(place.dot(up)) / tangent;
                most = Math.max(most, place.dot(back) + Math.max(aside, above));
            }
            return 1.08 * most;
        }

        this.look = (name) => {
            const direction = new THREE.Vector3().fromArray(directions[name]);
            controls.target.copy(sphere.center);
            camera.position.copy(direction.setLength(fittingDistance(direction))).add(sphere.center);
            controls.update();
            draw();
        };

        // Turns about the part's middle, in radians.
        this.turn = (aside, up) => {
            const offset = camera.position.clone().sub(controls.target);
            const place = new THREE.Spherical().setFromVector3(offset);
            place.theta += aside;
            place.phi += up;
            place.makeSafe();
            camera.position.setFromSpherical(place).add(controls.target);
            controls.update();
            draw();
        };

        this.zoom = (factor) => {
            const offset = camera.position.clone().sub(controls.target);
            const length = Math.min(Math.max(offset.length() * factor, controls.minDistance), controls.maxDistance);
            camera.position.copy(controls.target).add(offset.setLength(length));
            controls.update();
            draw();
        };

        this.wear = (material) => {
            scene.traverse((node) => {
                if (node.isMesh) {
                    node.material = material;
                }
            });
            draw();
        };

        this.fit = () => {
            const width = stage.clientWidth;
            const height = stage.clientHeight;
            if (width < 20 || height < 20) {
                return; // hidden, or about to be
            }
            const direction = camera.position.clone().sub(controls.target);
            const before = direction.length() > 0 ? fittingDistance(direction) : 1;
            renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
            renderer.setSize(width, height, false);
            camera.aspect = width / height;
            camera.near = sphere.radius / 100;
            camera.far = sphere.radius * 200;
            camera.updateProjectionMatrix();
            if (direction.length() > 0) {
                this.zoom(fittingDistance(direction) / before);
            }
        };

        this.anisotropy = renderer.capabilities.getMaxAnisotropy();
        controls.addEventListener('change', draw);
        canvas.addEventListener('webglcontextrestored', draw);
    }

    function showScale(layer) {
        const scale = document.querySelector('.scale');
        scale.textContent = '';
        if (layer.explanation) {
            scale.appendChild(document.createElement('p')).textContent = layer.explanation;
        }
        if (layer.steps.length > 0) {
            const list = scale.appendChild(document.createElement('ol'));
            for (const step of layer.steps) {
                const item = list.appendChild(document.createElement('li'));
                item.appendChild(document.createElement('i')).style.background = step.colour;
                item.appendChild(document.createTextNode(step.text));
            }
        }
    }

    // Materials without light would hide the part's shape.
    function lit(material) {
        return material.isMeshBasicMaterial
            ? new THREE.MeshLambertMaterial({ map: material.map, side: material.side })
            : material;
    }

    function start(gltf) {
        const viewer = new Viewer(gltf.scene);
        const materials = new Map();

        async function choose(key) {
            const number = Math.max(0, layers.findIndex((layer) => layer.key === key));
            radios[number].checked = true;
            const label = radios[number].parentElement;
            label.parentElement.scrollLeft = label.offsetLeft - 48;
            showScale(layers[number]);
            if (!materials.has(number)) {
                const material = lit(await gltf.parser.getDependency('material', number));
                material.map.anisotropy = viewer.anisotropy;
                materials.set(number, material);
            }
            if (radios[number].checked) {
                viewer.wear(materials.get(number));
                root.dataset.layer = layers[number].key;
            }
        }

        const keys = {
            ArrowLeft: () => viewer.turn(-0.12, 0),
            ArrowRight: () => viewer.turn(0.12, 0),
            ArrowUp: () => viewer.turn(0, -0.12),
            ArrowDown: () => viewer.turn(0, 0.12),
            '+': () => viewer.zoom(1 / 1.15),
            '=': () => viewer.zoom(1 / 1.15),
            '-': () => viewer.zoom(1.15),
            0: () => viewer.look('oblique'),
        };
        canvas.addEventListener('keydown', (event) => {
            if (keys[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
                keys[event.key]();
                event.preventDefault();
            }
        });
        for (const radio of radios) {
            radio.addEventListener('change', () => choose(radio.value).catch(fail));
        }
        for (const button of document.querySelectorAll('.views button')) {
            button.addEventListener('click', () => viewer.look(button.dataset.view));
        }
        // A link may name a layer and a view: proof.html#stretch,back
        async function follow() {
            const [layer, view] = location.hash.slice(1).split(',');
            await choose(layer);
            viewer.look(view in directions ? view : 'oblique');
        }

        viewer.fit();
        window.addEventListener('resize', viewer.fit);
        window.addEventListener('hashchange', () => follow().catch(fail));
        return follow().then(() => {
            for (const selector of ['.layers', '.views', '.help']) {
                document.querySelector(selector).hidden = false;
            }
            viewer.fit();
            document.querySelector('.wait').textContent = '';
            root.classList.add('ready');
            root.dataset.state = 'ready';
        });
    }

    try {
        new THREE.GLTFLoader().parse(bytesOf('model'), '', (gltf) => {
            Promise.resolve().then(() => start(gltf)).catch(fail);
        }, fail);
    } catch (error) {
        fail(error);
    }
}());
