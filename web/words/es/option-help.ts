/** What help says of options in Spanish. */
import type { Words } from '../words.js';

export const optionHelp: Words['optionHelp'] = {
  parts: 'número de partes',
  nets: 'file: conservar las plantillas y pestañas que trae el archivo (PDO); new: buscar otras',
  solver: 'tree: búsqueda local en árboles de expansión; genetic: evolución, como se publicó',
  heuristic:
    'para el aprendizaje: steepest (aristas más empinadas), flat (plano), hybrid (ambas cosas) o random (al azar)',
  segment: 'merge: plegabilidad y forma; spectral: solo plegabilidad',
  runs: 'rondas de aprendizaje',
  proxy: 'aprender con una copia más sencilla a partir de N caras; 0: nunca',
  seed: 'la misma semilla da el mismo resultado',
  faces: 'simplificar primero a N triángulos',
  repair:
    'pasos de la reparación que se hacen o no, como weld=off o cracks=off; se puede dar varias veces',
  'fill-holes':
    'rellenar los agujeros que miden como mucho ese porcentaje del lado más largo del modelo; all: todos',
  inside: 'los cuerpos que están dentro de otros: keep: conservarlos; drop: dejarlos fuera',
  crossing: 'los cuerpos que se atraviesan: keep: conservarlos; unite: unirlos',
  folding: 'plantillas sin forma de plegarlas: require: dividir; prefer: avisar; off: no mirarlo',
  clearance: 'cuánto se separan las caras al plegar, medido en el largo medio de las aristas',
  height: 'alto final, de abajo arriba; las piezas que no caben en la hoja se vuelven a cortar',
  width: 'ancho final: a lo largo de x, o de y si x va hacia arriba',
  depth: 'fondo final: a lo largo de z, o de y si z va hacia arriba',
  up: 'eje del archivo que va hacia arriba: x, y o z; guess: z en STL, si no y',
  scale: 'tamaño final: factor sobre el tamaño en la unidad del modelo',
  sheets: 'tan grande como quepa en N hojas',
  unit: 'unidad del modelo: mm, cm, m o in',
  paper: 'A2 a A5, Letter, Legal, Tabloid, 12x12in o WxH (ancho x alto) en mm',
  orientation: 'auto, portrait (vertical) o landscape (horizontal)',
  margin: 'margen que queda libre',
  flaps: 'altura de las pestañas; más bajas donde no hay sitio',
  'flap-angle': 'ángulo de sus lados en la base, como máximo',
  'flap-style':
    'pestañas en curvas suaves: edge: cada una como las demás; run: una tira con muescas estrechas; zigzag: dientes en punta',
  'flap-side': 'one: el lado con más sitio; alternate: por turno; both: los dos',
  'flap-borders': 'on: los bordes abiertos del modelo también llevan pestañas',
  'glue-strips':
    'tiras sueltas para aristas sin pestaña: none: ninguna; free: donde haya sitio en las hojas; all: también en hojas nuevas',
  ids: 'dónde van los números de las aristas cortadas: en las caras (inside), en las pestañas (flap) o en ambas (both), en las pestañas y lo que sobra (outside), o en ningún sitio (none)',
  'min-piece': 'los cuerpos del modelo más pequeños no se imprimen, y se avisa',
  compact:
    'on: plantillas con sitio para pestañas, contorno pequeño y cuellos fuertes; off: como se encontraron',
  workers:
    'hilos; auto: uno por núcleo, 4 como máximo; con cualquier número sale el mismo resultado',
  lang: 'idioma de todas las palabras: en la ayuda, los mensajes y las hojas',
  'flat-fold': 'los pliegues más planos no se dibujan',
  style: 'aspecto de las líneas: foldwright, pepakura o blender',
  'cut-width': 'grosor de los cortes',
  'cut-colour': 'color de los cortes',
  'mountain-width': 'grosor de los pliegues en montaña',
  'mountain-dash': 'trazos y huecos de los pliegues en montaña',
  'mountain-colour': 'color de los pliegues en montaña',
  'valley-width': 'grosor de los pliegues en valle',
  'valley-dash': 'trazos y huecos de los pliegues en valle',
  'valley-colour': 'color de los pliegues en valle',
  'flap-colour': 'con qué se rellenan las pestañas',
  'fold-ticks':
    'on: los pliegues son marcas de 3 mm en los dos extremos, o de un tercio del pliegue, en vez de líneas que cruzan la imagen',
  duplex:
    'on: detrás de cada hoja, una página con sus pliegues en espejo, para imprimir a doble cara volteando por el borde largo (PDF)',
  'fold-angles': 'imprimir junto a los pliegues cuánto se doblan',
  thickness: 'grosor del papel: las pestañas se pliegan donde queda su reverso',
  legend: 'imprimir una vez qué significan las líneas y los números',
  assembly:
    'on: páginas con una portada, una lista de piezas y los pasos para montar el modelo (PDF, SVG, PNG)',
  measured:
    'cuánto miden las reglas impresas de 50 mm, en horizontal y en vertical: corrige la escala de la impresora',
  machine:
    'para una máquina de corte: líneas para cortar, marcar y dibujar en colores puros; none: para tijeras',
  dpi: 'píxeles por pulgada de los archivos PNG, y de los colores e imágenes del modelo en todos los archivos',
  texture:
    'imprimir las caras con los colores e imágenes del modelo; auto: donde los haya, sin --colour part',
  colour:
    'part: imprimir cada pieza en el color de su parte, salvo que --texture on encuentre colores en el modelo',
  shading:
    'on: imprimir las luces y sombras de la superficie; en un modelo simplificado, las de la superficie de antes, para que los detalles se vean sin pliegues',
  'flap-bleed':
    'cuánto de una pestaña lleva los colores de su cara: none (nada), half (la mitad) o whole (todo)',
};
